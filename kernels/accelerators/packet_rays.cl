// A packet prepared for traversal: its rays, and intervals around them that reject 8 boxes at once.
#pragma once
#include "kernels/accelerators/packet.cl"

/// Bounds of the rays that are alive (t_max >= 0) along one axis. A box's plane p is passed at t = (p - from) * inverse.
typedef struct {
    float inverse_low, inverse_high;
    float from_near, from_far;  ///< origins that give the lowest t of the plane met first, and the highest of the other
    bool backward;              ///< the plane met first is the upper one
} PacketInterval;

typedef struct {
    ray_x16 rows[ROWS];
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

/// t_max of all rays.
FUNCTION float farthest_of(const PacketRays *packet) {
    float16 t_max = packet->rows[0].t_max;
    FOR_EACH_ROW(r) t_max = maximum(t_max, packet->rows[r].t_max);
    return largest_lanes(t_max, t_max, t_max, t_max).x;
}

/// From the largest of -inverse, inverse, -origin and origin. Where directions point both ways the axis rejects nothing.
FUNCTION PacketInterval packet_interval(float4 largest, float pad) {
    PacketInterval interval;
    interval.inverse_low = -largest.x, interval.inverse_high = largest.y;
    const float low = -largest.z - pad, high = largest.w + pad;
    interval.backward = interval.inverse_high < 0.0f;
    interval.from_near = interval.backward ? low : high, interval.from_far = interval.backward ? high : low;
    if (interval.inverse_low < 0.0f && !interval.backward) {
        interval.inverse_low = 1.0f, interval.inverse_high = 1.0f;
        interval.from_near = INFINITY, interval.from_far = -INFINITY;
    }
    return interval;
}

/// The pad is twice that of the rays' own box test, which makes up for the rounding of both.
FUNCTION void bound_rays(PacketRays *packet) {
    const float16 none = (float16)(-INFINITY);
    float16 back[3] = {none, none, none}, forth[3] = {none, none, none}, below[3] = {none, none, none}, above[3] = {none, none, none}, pads = none;
    FOR_EACH_ROW(r) {
        const ray_x16 *ray = &packet->rows[r];
        const int16 alive = ray->t_max >= 0.0f;
#define BOUND(axis, component)                                                 \
    back[axis] = maximum(back[axis], alive ? -ray->inverse.component : none);  \
    forth[axis] = maximum(forth[axis], alive ? ray->inverse.component : none); \
    below[axis] = maximum(below[axis], alive ? -ray->origin.component : none); \
    above[axis] = maximum(above[axis], alive ? ray->origin.component : none)
        BOUND(0, x);
        BOUND(1, y);
        BOUND(2, z);
#undef BOUND
        pads = maximum(pads, alive ? ray->pad : none);
    }
    const float pad = 2.0f * largest_lanes(pads, pads, pads, pads).x;
    packet->x = packet_interval(largest_lanes(back[0], forth[0], below[0], above[0]), pad);
    packet->y = packet_interval(largest_lanes(back[1], forth[1], below[1], above[1]), pad);
    packet->z = packet_interval(largest_lanes(back[2], forth[2], below[2], above[2]), pad);
    packet->farthest = farthest_of(packet);
}

/// The packet's rays whose direction is largest along `axis`; the others have t_max -1.
FUNCTION PacketRays packet_rays(const Packet *packet, uint axis, float extent) {
    PacketRays rays;
    FOR_EACH_ROW(r) {
        const Row *row = &packet->rows[r];
        const float16 t_max = lanes_along(row, axis) ? row->t_max : (float16)(-1.0f);
        rays.rows[r] = lane_ray(row->origin, row->direction, t_max, axis, row->source, extent);
        if (INSTANCES) rays.rows[r].source_instance = row->source_instance;
        SET_TIME(rays.rows[r], row->time);
    }
    bound_rays(&rays);
    return rays;
}

FUNCTION float8 first_near(PacketInterval interval, float8 low, float8 high) {
    const float8 from = (interval.backward ? high : low) - interval.from_near;
    return minimum(from * interval.inverse_low, from * interval.inverse_high);
}
FUNCTION float8 last_far(PacketInterval interval, float8 low, float8 high) {
    const float8 from = (interval.backward ? low : high) - interval.from_far;
    return maximum(from * interval.inverse_low, from * interval.inverse_high);
}

/// Which of the boxes a ray of the packet may meet before its t_max: none that it does meet is missing, so this changes no hit. `enter`: no ray
/// enters a box before, never negative.
FUNCTION int8 may_meet(const PacketRays *packet, box_x8 box, float8 *enter) {
    *enter = maximum(maximum(first_near(packet->x, box.low.x, box.high.x), first_near(packet->y, box.low.y, box.high.y)),
                     maximum(first_near(packet->z, box.low.z, box.high.z), (float8)(0.0f)));
    const float8 far = minimum(minimum(last_far(packet->x, box.low.x, box.high.x), last_far(packet->y, box.low.y, box.high.y)),
                               minimum(last_far(packet->z, box.low.z, box.high.z), (float8)(packet->farthest)));
    return !(*enter > far);
}

/// may_meet for the children of a node or the primitives of a block; words of all ones stand where there is none.
FUNCTION int8 candidates(const PacketRays *packet, const global uint *words, box_x8 box, float8 *enter) {
    return may_meet(packet, box, enter) & (*(const global uint8 *)words != (uint8)(NO_HIT));
}
