// What tests cost: many of one ray each, against one volume after another or one block after another. The next depends on the last result, so that
// neither vectorises nor overlaps more than a traversal lets it.
#include "kernels/accelerators/leaf.cl"
#include "kernels/accelerators/levels.cl"
#include "kernels/accelerators/volumes.cl"

#define TESTS 256u  ///< per ray

/// results[i]: volumes of one kind (VOLUME_..., the box alone with VOLUME_NONE) that ray i meets, of TESTS; there are a power of two of them.
kernel void test_volumes(const global Ray *restrict rays, uint count, float extent, const global VolumeNode *restrict nodes,
                         const global Volume *restrict volumes, uint last_volume, uint kind, global uint *restrict results) {
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const ray_x8 ray = prepare(rays[i], extent);
        const Line line = line_of(&ray);
        uint met = 0u, k = i & last_volume;
        for (uint n = 0u; n < TESTS; ++n) {
            const Stretch stretch = stretch_in_box(nodes[k].low, nodes[k].high, &ray);
            const bool meets = meets_volume(kind, volumes + k, line, stretch) && stretch.near <= stretch.far;
            met += meets;
            k = (k + 7u + meets) & last_volume;
        }
        results[i] = met;
    }
}

/// results[i]: blocks of primitives of the only kind in which ray i hits something, of TESTS; there are a power of two of them.
kernel void test_blocks(SCENE_PARAMS, const global Ray *restrict rays, uint count, uint last_block, global uint *restrict results) {
    const Scene scene = SCENE;
    const global Group *world = &scene.header->world;
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const ray_x8 ray = prepare_in_world(world, rays[i], PLACEMENT(0u, 0.0f));
        uint met = 0u, block = i & last_block;
        for (uint n = 0u; n < TESTS; ++n) {
            const bool meets = block_any_hit(scene, world, 0u, block, &ray, 0);
            met += meets;
            block = (block + 7u + meets) & last_block;
        }
        results[i] = met;
    }
}
