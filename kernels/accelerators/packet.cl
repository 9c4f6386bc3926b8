// Packets of 16 rays: made of a list of rays, and intervals around them that reject 8 boxes at once.
#pragma once
#include "generated/constants.h"
#include "kernels/core/items.h"
#include "kernels/core/rays.cl"
#include "kernels/core/transpose.cl"

#include "kernels/core/lanes_16.cl"
#include "kernels/core/lane_ray.cl"

#include "kernels/core/lanes_1.cl"

#define PACKET 16u

/// Bounds of the rays that are alive (t_max >= 0) along one axis. A box's plane p is passed at t = (p - from) * inverse.
typedef struct {
    float inverse_low, inverse_high;
    float from_near, from_far;  ///< origins that give the lowest t of the plane met first, and the highest of the other
    bool backward;              ///< the plane met first is the upper one
} PacketInterval;

/// A packet for traversal.
typedef struct {
    ray_x16 rays;
    PacketInterval x, y, z;
    float farthest;  ///< t_max of all
} PacketRays;

FUNCTION float4 larger(float4 a, float4 b) { return a > b ? a : b; }
FUNCTION float4 largest_quarter(float16 v) {
    const float8 halves = maximum(v.lo, v.hi);
    return larger(halves.lo, halves.hi);
}
/// The largest lanes of four.
FUNCTION float4 largest_lanes(float16 a, float16 b, float16 c, float16 d) {
    const float4 qa = largest_quarter(a), qb = largest_quarter(b), qc = largest_quarter(c), qd = largest_quarter(d);
    const float4 ab = larger((float4)(qa.lo, qb.lo), (float4)(qa.hi, qb.hi)), cd = larger((float4)(qc.lo, qd.lo), (float4)(qc.hi, qd.hi));
    return larger((float4)(ab.even, cd.even), (float4)(ab.odd, cd.odd));
}
FUNCTION float largest_lane(float16 v) { return largest_lanes(v, v, v, v).x; }

/// Where directions point both ways the axis rejects nothing.
FUNCTION PacketInterval packet_interval(float16 origin, float16 inverse, float pad, int16 alive) {
#define OF_ALIVE(values) (alive ? (values) : (float16)(-INFINITY))
    const float4 bounds = largest_lanes(OF_ALIVE(-inverse), OF_ALIVE(inverse), OF_ALIVE(-origin), OF_ALIVE(origin));
#undef OF_ALIVE
    PacketInterval interval;
    interval.inverse_low = -bounds.x, interval.inverse_high = bounds.y;
    const float low = -bounds.z - pad, high = bounds.w + pad;
    interval.backward = interval.inverse_high < 0.0f;
    interval.from_near = interval.backward ? low : high, interval.from_far = interval.backward ? high : low;
    if (interval.inverse_low < 0.0f && !interval.backward) {
        interval.inverse_low = 1.0f, interval.inverse_high = 1.0f;
        interval.from_near = INFINITY, interval.from_far = -INFINITY;
    }
    return interval;
}

FUNCTION int16 are_numbers(vec3x16 v) { return (v.x == v.x) & (v.y == v.y) & (v.z == v.z); }

/// The pad is twice that of the rays' own box test, which makes up for the rounding of both. Rays with a NaN meet nothing, and must not hide the
/// bounds of others.
FUNCTION PacketRays packet_of_rays(ray_x16 rays) {
    PacketRays packet;
    packet.rays = rays;
    const int16 alive = (rays.t_max >= 0.0f) & are_numbers(rays.origin) & are_numbers(rays.inverse);
    const float4 ends = largest_lanes(alive ? rays.pad : (float16)(0.0f), rays.t_max, rays.t_max, rays.t_max);
    const float pad = 2.0f * ends.x;
    packet.x = packet_interval(rays.origin.x, rays.inverse.x, pad, alive);
    packet.y = packet_interval(rays.origin.y, rays.inverse.y, pad, alive);
    packet.z = packet_interval(rays.origin.z, rays.inverse.z, pad, alive);
    packet.farthest = ends.y;
    return packet;
}

FUNCTION float8 first_near(PacketInterval interval, float8 low, float8 high) {
    const float8 from = (interval.backward ? high : low) - interval.from_near;
    return minimum(from * interval.inverse_low, from * interval.inverse_high);
}
FUNCTION float8 last_far(PacketInterval interval, float8 low, float8 high) {
    const float8 from = (interval.backward ? low : high) - interval.from_far;
    return maximum(from * interval.inverse_low, from * interval.inverse_high);
}

/// Bits of the boxes that a ray of the packet may meet before its t_max: none that it does meet is missing, so this changes no hit.
FUNCTION uint may_meet(const PacketRays *packet, box_x8 box) {
    const float8 near = maximum(maximum(first_near(packet->x, box.low.x, box.high.x), first_near(packet->y, box.low.y, box.high.y)),
                                maximum(first_near(packet->z, box.low.z, box.high.z), (float8)(0.0f)));
    const float8 far = minimum(minimum(last_far(packet->x, box.low.x, box.high.x), last_far(packet->y, box.low.y, box.high.y)),
                               minimum(last_far(packet->z, box.low.z, box.high.z), (float8)(packet->farthest)));
    return mask_bits(!(near > far));
}

/// may_meet for the children of a node or the primitives of a block; words of all ones stand where there is none.
FUNCTION uint candidates(const PacketRays *packet, const global uint *words, box_x8 box) {
    return may_meet(packet, box) & mask_bits(*(const global uint8 *)words != (uint8)(NO_HIT));
}

/// Rays of a list, lane by lane, or of the same lanes.
typedef struct {
    vec3x16 origin, direction;
    float16 t_max;
    int16 tag, axis;        ///< axis of the largest component of the direction
    int16 source;           ///< number of the primitive that it leaves
    int16 source_instance;  ///< and the instance which that is in; only in scenes with instances
} Packet;

/// Axis of the largest component of each direction.
FUNCTION int16 major_axes(vec3x16 d) {
    const float16 x = fabs(d.x), y = fabs(d.y), z = fabs(d.z);
    return ((x >= y) & (x >= z)) ? (int16)(0) : y >= z ? (int16)(1) : (int16)(2);
}

/// Rays first .. first + 15 of a list; lanes beyond `last` repeat the last ray and have t_max -1. The instance of what ray k leaves is
/// source_instances[k - skipped], which only scenes with instances have.
FUNCTION Packet packet_of(const global Ray *rays, const global uint *live, uint first, uint last, const global uint *source_instances, uint skipped) {
    float16 starts[4], ends[4], start[4], end[4];
    for (uint r = 0u; r < 4u; ++r) {
#define HALF(quarter, half) vload4(half, (const global float *)(rays + live[min(first + 4u * quarter + r, last - 1u)]))
        starts[r] = (float16)(HALF(0u, 0), HALF(1u, 0), HALF(2u, 0), HALF(3u, 0));
        ends[r] = (float16)(HALF(0u, 1), HALF(1u, 1), HALF(2u, 1), HALF(3u, 1));
#undef HALF
    }
    transpose_fields(starts, start), transpose_fields(ends, end);
    Packet packet;
    packet.origin = make3(start[0], start[1], start[2]);
    packet.direction = make3(end[0], end[1], end[2]);
    const int16 lane = (int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    packet.t_max = lane < (int16)((int)(last - first)) ? start[3] : (float16)(-1.0f);
    packet.tag = as_int16(end[3]);
    packet.axis = major_axes(packet.direction);
    packet.source = (packet.tag >> 2 & 0x3fffffff) - 1;
    if (INSTANCES) {
        int sources[PACKET];
        for (uint j = 0u; j < PACKET; ++j) sources[j] = (int)source_instances[live[min(first + j, last - 1u)] - skipped];
        packet.source_instance = vload16(0, sources);
    }
    return packet;
}

/// The packet's rays whose direction is largest along `axis`; the others have t_max -1. Their lanes are marked in `lanes`.
FUNCTION PacketRays packet_rays(const Packet *packet, uint axis, float extent, int16 lanes) {
    ray_x16 rays = lane_ray(packet->origin, packet->direction, lanes ? packet->t_max : (float16)(-1.0f), axis, packet->source, extent);
    if (INSTANCES) rays.source_instance = packet->source_instance;
    return packet_of_rays(rays);
}

/// The lanes of the packet's rays whose direction is largest along `axis`.
FUNCTION int16 packet_lanes(const Packet *packet, uint axis) { return (packet->axis == (int16)((int)axis)) & (packet->t_max >= 0.0f); }
