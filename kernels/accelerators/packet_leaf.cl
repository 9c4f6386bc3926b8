// Blocks of primitives against a packet, one primitive after another.
#pragma once
#include "generated/primitives.cl"
#include "kernels/accelerators/packet_hits.cl"
#include "kernels/accelerators/packet_rays.cl"
#include "kernels/accelerators/primitive_hits_8.cl"
#include "kernels/core/bits.cl"
#include "kernels/core/items.cl"
#include "kernels/core/scene.cl"

#include "kernels/core/lanes_16.cl"
#include "generated/primitive_hits.cl"

#include "kernels/core/lanes_1.cl"

#define ALL_ROWS ((1u << ROWS) - 1u)

/// Bits of the block's primitives whose boxes the packet may meet.
#define CANDIDATES_OF(name, packet, block, bits) \
    float8 enter;                                \
    box_x8 box;                                  \
    name##_box(block, 0u, &box);                 \
    uint bits = mask_bits(candidates(packet, (block)->primitive, box, &enter))

/// block_closest_hit for the packet's rows whose bits are set.
FUNCTION void block_closest_hits(Scene scene, const global Group *group, uint kind, uint block, uint rows, PacketRays *packet, PacketHits *hits) {
    bool nearer = false;
#define CROSS_EACH(KIND, Record, name)                                                                    \
    if (kind == KIND) {                                                                                   \
        const global Record##Block *b = RECORDS(scene, Record##Block, group->blocks[KIND]) + block;       \
        CANDIDATES_OF(name, packet, b, bits);                                                             \
        for (; bits != 0u; bits &= bits - 1u) {                                                           \
            const uint j = lowest_bit(bits);                                                              \
            FOR_EACH_ROW(r) {                                                                             \
                if ((rows >> r & 1u) == 0u) continue;                                                     \
                const crossing_x16 crossing = name##_crossing(b, j, packet->rows[r]);                     \
                if (mask_bits(crossing.hit) == 0u) continue;                                              \
                take_crossing(crossing, b->primitive[j], hits->inside, &packet->rows[r], &hits->rows[r]); \
                nearer = true;                                                                            \
            }                                                                                             \
        }                                                                                                 \
    }
    FOR_EACH_PRIMITIVE(CROSS_EACH)
#undef CROSS_EACH
    if (nearer) packet->farthest = farthest_of(packet);
}

/// Ends the rays of such rows that meet a primitive of the block: their t_max becomes -1.
FUNCTION void block_ends_rays(Scene scene, const global Group *group, uint kind, uint block, uint rows, PacketRays *packet) {
#define END_EACH(KIND, Record, name)                                                                \
    if (kind == KIND) {                                                                             \
        const global Record##Block *b = RECORDS(scene, Record##Block, group->blocks[KIND]) + block; \
        CANDIDATES_OF(name, packet, b, bits);                                                       \
        for (; bits != 0u; bits &= bits - 1u) {                                                     \
            const uint j = lowest_bit(bits);                                                        \
            FOR_EACH_ROW(r) {                                                                       \
                if ((rows >> r & 1u) == 0u) continue;                                               \
                ray_x16 *ray = &packet->rows[r];                                                    \
                ray->t_max = name##_crossing(b, j, *ray).hit ? (float16)(-1.0f) : ray->t_max;       \
            }                                                                                       \
        }                                                                                           \
    }
    FOR_EACH_PRIMITIVE(END_EACH)
#undef END_EACH
}

FUNCTION bool all_ended(const PacketRays *packet) {
    int16 alive = (int16)(0);
    FOR_EACH_ROW(r) alive |= packet->rows[r].t_max >= 0.0f;
    return mask_bits(alive) == 0u;
}
