// Rows of rays against all primitives of the world, without a way through an accelerator's nodes: where there are few of them. Of each block, those
// that a lane may cross are found out first, without a branch for any of them, because a processor would guess most of these wrong.
#pragma once
#include "generated/primitives.cl"
#include "kernels/accelerators/packet_hits.cl"
#include "kernels/core/bits.cl"
#include "kernels/core/scene.cl"

#include "kernels/core/lanes_16.cl"
#include "generated/primitive_hits.cl"

#include "kernels/core/lanes_1.cl"

/// A row whose rays all go most along one axis, prepared.
typedef struct {
    ray_x16 rays;
    float16 doubt;  ///< as ray_doubt gives it
} TracedRow;

/// By how much t times the determinant of triangle_may_meet can be off what triangle_crossing makes of it: with R = |origin| + extent, sheared
/// coordinates are at most 2 R, so that the rounding of the edge functions makes up less than 2^-17 R³, and what counts as near there, 2^-12 R³.
FUNCTION float16 ray_doubt(const ray_x16 *rays, float extent) {
    const float16 r = largest(absolute(rays->origin)) + extent;
    return 0x1p-11f * r * r * r * fabs(rays->shear.z);
}

FUNCTION TracedRow traced_row(const Row *row, uint axis, float extent) {
    TracedRow traced;
    traced.rays = lane_ray(row->origin, row->direction, row->t_max, axis, row->source, extent);
    traced.doubt = ray_doubt(&traced.rays, extent);
    return traced;
}

/// Bits of primitives of a block that a ray may cross: its first ones are taken.
#define CANDIDATES_OF_ROW(name, block, row, bits)                                                        \
    const uint size = popcount(mask_bits(*(const global uint8 *)(block)->primitive != (uint8)(NO_HIT))); \
    uint bits = 0u;                                                                                      \
    for (uint j = 0u; j < size; ++j) bits |= (uint)(mask_bits(name##_may_meet(block, j, (row)->rays, (row)->doubt)) != 0u) << j

/// MEET(name, block, j) for each primitive j of block n of its kind that a ray of the row may cross.
#define MEET_BLOCK(KIND, Record, name, n, MEET)                                                       \
    {                                                                                                 \
        const global Record##Block *block = RECORDS(scene, Record##Block, world->blocks[KIND]) + (n); \
        CANDIDATES_OF_ROW(name, block, row, bits);                                                    \
        for (; bits != 0u; bits &= bits - 1u) MEET(name, block, lowest_bit(bits));                    \
    }
/// And of all blocks.
#define MEET_ALL(KIND, Record, name, MEET) \
    for (uint n = 0u; n < world->blocks[KIND].count; ++n) MEET_BLOCK(KIND, Record, name, n, MEET)

/// The lanes take what they meet there.
#define TAKE_CROSSING(name, block, j) take_crossing(name##_crossing(block, j, row->rays), (block)->primitive[j], 0u, &row->rays, hits)
/// Those that meet it have t_max -1.
#define END_CROSSING(name, block, j) row->rays.t_max = name##_crossing(block, j, row->rays).hit ? (float16)(-1.0f) : row->rays.t_max

FUNCTION void row_closest_hits(Scene scene, TracedRow *row, RowHits *hits) {
    const global Group *world = &scene.header->world;
#define TAKE_ALL(KIND, Record, name) MEET_ALL(KIND, Record, name, TAKE_CROSSING)
    FOR_EACH_PRIMITIVE(TAKE_ALL)
#undef TAKE_ALL
}

/// Bits of the rays that meet something before their t_max.
FUNCTION uint row_occluded(Scene scene, TracedRow *row) {
    const global Group *world = &scene.header->world;
    const uint alive = mask_bits(row->rays.t_max >= 0.0f);
#define END_ALL(KIND, Record, name) MEET_ALL(KIND, Record, name, END_CROSSING)
    FOR_EACH_PRIMITIVE(END_ALL)
#undef END_ALL
    return alive & mask_bits(row->rays.t_max < 0.0f);
}
