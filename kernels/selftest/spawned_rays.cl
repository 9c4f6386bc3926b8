// Rays that leave one kind of primitive where a first ray has met it: primitive i, ray i, and a direction.
#include "kernels/selftest/one_lane.cl"
#include "kernels/core/spawn.cl"

typedef struct {
    vec3 p, error, geometric;  ///< of the surface that was met
    vec3 origin;               ///< of the ray that leaves it
    float t;                   ///< where that one meets the primitive
    uint first_hit, second_hit;
} SpawnResult;

/// The second ray does not say which primitive it leaves: flat ones too must get away by their own strength.
kernel void test_spawned_rays(SCENE_PARAMS, const global Block *restrict blocks, const global ShadingRecord *restrict records,
                              const global float *restrict extents, const global Ray *restrict rays, const global vec3 *restrict directions,
                              uint count, global SpawnResult *restrict results) {
    const Scene scene = SCENE;
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const Crossing first = cross_one(blocks, i, rays[i], extents[i]);
        results[i].first_hit = first.hit != 0;
        if (!first.hit) continue;
        const Surface surface = NAME(surface)(scene, records[i], rays[i], hit_of(first, i));
        const float side = dot3(surface.geometric, directions[i]) < 0.0f ? -1.0f : 1.0f;
        const vec3 offset = scaled(surface.geometric, side * dot3(absolute(surface.geometric), surface.error));
        const Ray next = ray_spawn(spawn_origin(surface.p, offset), directions[i], RAY_REFLECTED, NO_HIT);
        const Crossing second = cross_one(blocks, i, next, extents[i]);
        results[i].p = surface.p, results[i].error = surface.error, results[i].geometric = surface.geometric;
        results[i].origin = next.origin, results[i].t = second.t, results[i].second_hit = second.hit != 0;
    }
}
