// Closest hits of a list of rays, one ray after another: for rays that go their own ways.
#include "kernels/accelerators/levels.cl"

/// hits[i] is the closest hit of ray live[first + i]; a hit beyond t_max or none has primitive NO_HIT. One tally per work-item.
/// In scenes with transparent materials crowded[i] tells whether more is met at nearly the same place.
kernel void intersect(SCENE_PARAMS, LIVE_PARAMS, const global Ray *restrict rays, global Hit *restrict hits, global uchar *restrict crowded,
                      global Tally *restrict tallies) {
    const Scene scene = SCENE;
    Tally tally = {{0u}, {0u}};
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const Ray ray = rays[live[first + i]];
        const Nearest nearest = scene_closest_hit(scene, ray);
        const Hit hit = nearest.hit;
        hits[i] = hit;
        if (INTERIOR_SIZE > 0u) crowded[i] = is_crowded(nearest);
        tally.rays[RAY_KIND(ray.tag)] += 1u;
        tally.hits[RAY_KIND(ray.tag)] += hit.primitive != NO_HIT;
    }
    tallies[get_global_id(0)] = tally;
}
