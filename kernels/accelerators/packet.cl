// Packets of neighbouring rays of a list, in rows of 16 lanes: two, unless who includes this has another number. The more rows, the fewer times a
// node is met, and the more rays go where only some of them have to.
#pragma once
#include "generated/constants.h"
#include "generated/instances.cl"
#include "kernels/core/items.h"
#include "kernels/core/rays.cl"
#include "kernels/core/transpose.cl"

#include "kernels/core/lanes_16.cl"
#include "kernels/core/lane_ray.cl"

#include "kernels/core/lanes_1.cl"

#define ROW 16u
#ifndef ROWS
#define ROWS 2u
#endif
#define PACKET (ROW * ROWS)

#define FOR_EACH_ROW(r) _Pragma("unroll") for (uint r = 0u; r < ROWS; ++r)

/// Rays of a list, lane by lane.
typedef struct {
    vec3x16 origin, direction;
    float16 t_max;
    int16 tag, axis;        ///< axis of the largest component of the direction
    int16 source;           ///< number of the primitive that it leaves
    int16 source_instance;  ///< and the instance which that is in; only in scenes with instances
    TIME_OF_ROW
} Row;

typedef struct {
    Row rows[ROWS];
} Packet;

/// Axis of the largest component of each direction.
FUNCTION int16 major_axes(vec3x16 d) {
    const float16 x = fabs(d.x), y = fabs(d.y), z = fabs(d.z);
    return ((x >= y) & (x >= z)) ? (int16)(0) : y >= z ? (int16)(1) : (int16)(2);
}

FUNCTION void take_sources(const uint *numbers, const global uint *source_instances, uint skipped, Row *row) {
    int sources[ROW];
    for (uint j = 0u; j < ROW; ++j) {
        const Placement source = instance_at(source_instances, numbers[j] - skipped);
        sources[j] = (int)instance_number(source);
        SET_LANE_TIME(*row, j, source.time);
    }
    row->source_instance = vload16(0, sources);
}

/// The rays of 16 numbers, of which the first `count` count: the other lanes have t_max -1. The instance of what ray k leaves is
/// source_instances[k - skipped], which only scenes with instances have.
FUNCTION Row row_of(const global Ray *rays, const uint *numbers, uint count, const global uint *source_instances, uint skipped) {
    float16 starts[4], ends[4], start[4], end[4];
    for (uint r = 0u; r < 4u; ++r) {
#define HALF(quarter, half) vload4(half, (const global float *)(rays + numbers[4u * quarter + r]))
        starts[r] = (float16)(HALF(0u, 0), HALF(1u, 0), HALF(2u, 0), HALF(3u, 0));
        ends[r] = (float16)(HALF(0u, 1), HALF(1u, 1), HALF(2u, 1), HALF(3u, 1));
#undef HALF
    }
    transpose_fields(starts, start), transpose_fields(ends, end);
    Row row;
    row.origin = make3(start[0], start[1], start[2]);
    row.direction = make3(end[0], end[1], end[2]);
    const int16 lane = (int16)(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    row.t_max = lane < (int16)((int)count) ? start[3] : (float16)(-1.0f);
    row.tag = as_int16(end[3]);
    row.axis = major_axes(row.direction);
    row.source = (row.tag >> 2 & 0x3fffffff) - 1;
    if (INSTANCES) take_sources(numbers, source_instances, skipped, &row);
    return row;
}

/// Rays first .. first + 15 of a list, of which those from `last` on do not count.
FUNCTION Row row_of_list(const global Ray *rays, const global uint *live, uint first, uint last, const global uint *source_instances, uint skipped) {
    uint numbers[ROW];
    for (uint j = 0u; j < ROW; ++j) numbers[j] = live[min(first + j, last - 1u)];
    return row_of(rays, numbers, last - min(first, last), source_instances, skipped);
}

/// row_of_list for rays first .. first + PACKET - 1.
FUNCTION Packet packet_of(const global Ray *rays, const global uint *live, uint first, uint last, const global uint *source_instances, uint skipped) {
    Packet packet;
    FOR_EACH_ROW(r) packet.rows[r] = row_of_list(rays, live, first + r * ROW, last, source_instances, skipped);
    return packet;
}

/// How many of the rays first .. last - 1 are in row r of their packet.
FUNCTION uint rays_of_row(uint r, uint first, uint last) { return min(ROW, last - min(first + r * ROW, last)); }

/// The lanes of the rays whose direction is largest along `axis`.
FUNCTION int16 lanes_along(const Row *row, uint axis) { return (row->axis == (int16)((int)axis)) & (row->t_max >= 0.0f); }

FUNCTION bool any_along(const Packet *packet, uint axis) {
    int16 lanes = (int16)(0);
    FOR_EACH_ROW(r) lanes |= lanes_along(&packet->rows[r], axis);
    return mask_bits(lanes) != 0u;
}
