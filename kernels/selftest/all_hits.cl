// All that a ray meets in a scene: in closed meshes nothing gets out.
#include "kernels/accelerators/levels.cl"
#include "kernels/selftest/all_hits.h"

kernel void test_all_hits(SCENE_PARAMS, const global Ray *restrict rays, uint count, global MetPrimitives *restrict met) {
    const Scene scene = SCENE;
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const Ray ray = rays[i];
        HitList list = empty_list();
        scene_any_hit(scene, ray, PLACEMENT(0u, 0.0f), &list);
        MetPrimitives of_ray;
        of_ray.closest = scene_closest_hit(scene, ray, PLACEMENT(0u, 0.0f)).hit.primitive;
        for (uint k = 0u; k < HIT_LIST_SIZE; ++k) of_ray.all[k] = k < list.count ? list.hits[k].hit.primitive : NO_HIT;
        met[i] = of_ray;
    }
}
