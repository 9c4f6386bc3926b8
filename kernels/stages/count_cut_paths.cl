// How often the depth limit has an effect.
#pragma OPENCL EXTENSION cl_khr_int64_base_atomics : enable
#include "kernels/core/items.cl"
#include "kernels/core/scene.cl"

/// Adds to cut[0] how many of `count` hits are of materials that have one of `flags`.
kernel void count_cut_paths(SCENE_PARAMS, uint flags, uint count, const global SurfacePoint *restrict points, global ulong *restrict cut) {
    const Scene scene = SCENE;
    const global Material *materials = SCENE_ARRAY(scene, Material, materials);
    ulong of_chunk = 0ul;
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const SurfacePoint point = points[i];
        const bool sends = (point.flags & SURFACE_HIT) != 0u && (materials[point.material].flags & flags) != 0u;
        of_chunk += sends ? 1ul : 0ul;
    }
    if (of_chunk > 0ul) atom_add(cut, of_chunk);
}
