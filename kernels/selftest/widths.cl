// One kind of primitive at 8 and at 16 lanes, as the accelerators' leaves call it: primitive i against ray i.
#include "kernels/selftest/one_lane.cl"
#include "kernels/core/rays.cl"

#include "kernels/core/lanes_8.cl"
#include "generated/primitive_hits.cl"

#include "kernels/core/lanes_16.cl"
#include "kernels/core/lane_ray.cl"
#include "generated/primitive_hits.cl"

#include "kernels/core/lanes_1.cl"

FUNCTION ray_x16 packet_of_one(Ray ray, float extent) {
    const vec3x16 origin = make3((float16)(ray.origin.x), (float16)(ray.origin.y), (float16)(ray.origin.z));
    const vec3x16 direction = make3((float16)(ray.direction.x), (float16)(ray.direction.y), (float16)(ray.direction.z));
    return lane_ray(origin, direction, (float16)(ray.t_max), major_axis(ray.direction), (int16)((int)RAY_SOURCE(ray.tag)), extent);
}

FUNCTION bool same(crossing_x1 a, float t, float u, float v, int hit) {
    const bool numbers = as_uint(a.t) == as_uint(t) && as_uint(a.u) == as_uint(u) && as_uint(a.v) == as_uint(v);
    return (a.hit != 0) == (hit != 0) && (hit == 0 || numbers);
}

/// Bit 0: 8 lanes give other bits than one; bit 1: 16 lanes do.
kernel void test_widths(const global Block *restrict blocks, const global float *restrict extents, const global Ray *restrict rays, uint count,
                        global uchar *restrict differences) {
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const Ray ray = rays[i];
        const crossing_x1 one = cross_one(blocks, i, ray, extents[i]);
        const crossing_x8 of_8 = NAME(crossing)(blocks + i / BLOCK_SIZE, 0u, prepare(ray, extents[i]));
        const crossing_x16 of_16 = NAME(crossing)(blocks + i / BLOCK_SIZE, i % BLOCK_SIZE, packet_of_one(ray, extents[i]));
        float t[8], u[8], v[8];
        int hit[8];
        vstore8(of_8.t, 0, t), vstore8(of_8.u, 0, u), vstore8(of_8.v, 0, v), vstore8(of_8.hit, 0, hit);
        const uint j = i % BLOCK_SIZE;
        const bool same_8 = same(one, t[j], u[j], v[j], hit[j]), same_16 = same(one, of_16.t.s0, of_16.u.s0, of_16.v.s0, of_16.hit.s0);
        differences[i] = (uchar)((same_8 ? 0u : 1u) | (same_16 ? 0u : 2u));
    }
}
