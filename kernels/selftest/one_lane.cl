// What the primitive NAME does with one ray, one lane wide, in the precision in force: where they cross, and the surface there.
#include "generated/precision.cl"
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/lane_ray.cl"
#include "kernels/core/scene.cl"
#include "kernels/core/major_axis.cl"
#include "generated/kind.cl"
#include "generated/primitive_hits.cl"
#include "generated/primitive_surfaces.cl"

FUNCTION Crossing cross_one(const global Block *blocks, uint i, Ray ray, float extent) {
    const LaneRay lane = lane_ray(ray.origin, ray.direction, ray.t_max, major_axis(ray.direction), (int)RAY_SOURCE(ray.tag), extent);
    return NAME(crossing)(blocks + i / BLOCK_SIZE, i % BLOCK_SIZE, lane);
}

FUNCTION Hit hit_of(Crossing crossing, uint primitive) {
    Hit hit;
    hit.t = crossing.t, hit.u = crossing.u, hit.v = crossing.v, hit.primitive = primitive;
    return hit;
}
