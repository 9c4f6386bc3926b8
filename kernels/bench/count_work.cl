// What an accelerator does for rays, one ray after another: the same hits and shadows as of the tracing stages, with counts.
#include "generated/instances.cl"
#include "generated/work.cl"
#include "kernels/accelerators/levels.cl"
#include "kernels/accelerators/work.h"

FUNCTION Work no_work(void) {
    const Work work = {0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u};
    return work;
}

/// As intersect, of the rays 0 ... count, with the work for each.
kernel void count_closest_hits(SCENE_PARAMS, uint count, const global Ray *restrict rays, const global uint *restrict sources,
                               global Hit *restrict hits, global uint *restrict instances, global Work *restrict works) {
    const Scene scene = SCENE;
    const global Group *world = &scene.header->world;
    FOR_EACH_ITEM_SERIALLY(i, count) {
        Work work = no_work();
        SingleRay prepared = prepare_in_world(world, rays[i], instance_at(sources, i));
        COUNT_IN(prepared, &work);
        Nearest nearest = nothing_hit(rays[i], world->extent);
        SET_TIME(nearest, instance_at(sources, i).time);
        world_closest_hit(scene, world, &prepared, &nearest);
        hits[i] = nearest.hit;
        store_instance(instances, i, place_of(closest_of(nearest)));
        works[i] = work;
    }
}

/// As trace_shadow_rays, of one row without gaps: visible[i] becomes 1 where nothing is met before the ray's t_max, else 0.
kernel void count_shadows(SCENE_PARAMS, uint count, const global Ray *restrict rays, const global uint *restrict sources,
                          global uchar *restrict visible, global Work *restrict works) {
    const Scene scene = SCENE;
    const global Group *world = &scene.header->world;
    FOR_EACH_ITEM_SERIALLY(i, count) {
        Work work = no_work();
        SingleRay prepared = prepare_in_world(world, rays[i], instance_at(sources, i));
        COUNT_IN(prepared, &work);
        visible[i] = !world_any_hit(scene, world, &prepared, 0);
        works[i] = work;
    }
}
