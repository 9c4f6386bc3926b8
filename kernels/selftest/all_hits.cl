// All that a ray meets in a scene: in closed meshes nothing gets out.
#include "kernels/accelerators/levels.cl"
#include "kernels/primitives/placed.cl"

/// closest[i]: whether ray i has a closest hit. places[i]: how many hits it has in all, those of neighbours that share the edge which it meets being
/// one; of at most HIT_LIST_SIZE.
kernel void test_all_hits(SCENE_PARAMS, const global Ray *restrict rays, uint count, global uchar *restrict closest, global uchar *restrict places) {
    const Scene scene = SCENE;
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const Ray ray = rays[i];
        closest[i] = scene_closest_hit(scene, ray, 0u).hit.primitive != NO_HIT;
        HitList list = empty_list();
        scene_any_hit(scene, ray, 0u, &list);
        uchar distinct = 0;
        Surface last;
        for (uint k = 0u; k < list.count; ++k) {
            const Surface surface = surface_of(scene, ray, list.hits[k]);
            if (k == 0u || !coincide(last, surface)) ++distinct;
            last = surface;
        }
        places[i] = distinct;
    }
}
