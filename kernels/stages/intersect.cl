// Closest hits of a list of rays, one ray after another: for rays that go their own ways.
#include "generated/instances.cl"
#include "kernels/accelerators/levels.cl"
#include "kernels/core/tally.cl"

/// hits[i] is the closest hit of ray live[first + i]; a hit beyond t_max or none has primitive NO_HIT. Rays and hits are added to a tally per
/// work-item. In scenes with transparent materials crowded[i] tells whether more is met at nearly the same place. In scenes with instances sources[k]
/// is that of the primitive which ray k leaves, and instances[i] becomes that of the hit, 0 for none.
kernel void intersect(SCENE_PARAMS, LIVE_PARAMS, const global Ray *restrict rays, const global uint *restrict sources, global Hit *restrict hits,
                      global uint *restrict instances, global uchar *restrict crowded, global Tally *restrict tallies) {
    const Scene scene = SCENE;
    Tally tally = {{0ul}, {0ul}};
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const uint k = live[first + i];
        const Ray ray = rays[k];
        const Nearest nearest = scene_closest_hit(scene, ray, instance_at(sources, k));
        const Hit hit = nearest.hit;
        hits[i] = hit;
        store_instance(instances, i, place_of(closest_of(nearest)));
        if (INTERIOR_SIZE > 0u) crowded[i] = is_crowded(nearest);
        tally.rays[RAY_KIND(ray.tag)] += 1u;
        tally.hits[RAY_KIND(ray.tag)] += hit.primitive != NO_HIT;
    }
    add_tally(tallies + get_global_id(0), tally);
}
