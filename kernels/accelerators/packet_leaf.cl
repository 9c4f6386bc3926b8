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

/// MEET(name, block, j, ray, r) for primitives j of the block, where `kind` is theirs, and rows r whose bits are set, with their rays.
#define MEET_EACH(KIND, Record, name, MEET)                                                         \
    if (kind == KIND) {                                                                             \
        const global Record##Block *b = RECORDS(scene, Record##Block, group->blocks[KIND]) + block; \
        CANDIDATES_OF(name, packet, b, bits);                                                       \
        for (; bits != 0u; bits &= bits - 1u) {                                                     \
            const uint j = lowest_bit(bits);                                                        \
            FOR_EACH_ROW(r) {                                                                       \
                if ((rows >> r & 1u) != 0u) MEET(name, b, j, (&packet->rows[r]), r);                \
            }                                                                                       \
        }                                                                                           \
    }

/// block_closest_hit for the packet's rows whose bits are set.
FUNCTION void block_closest_hits(Scene scene, const global Group *group, uint kind, uint block, uint rows, PacketRays *packet, PacketHits *hits) {
    bool nearer = false;
#define TAKE(name, block, j, ray, r) \
    nearer |= take_crossing(name##_crossing(block, j, *ray), (block)->primitive[j], hits->inside, ray, &hits->rows[r])
#define TAKE_EACH(KIND, Record, name) MEET_EACH(KIND, Record, name, TAKE)
    FOR_EACH_PRIMITIVE(TAKE_EACH)
#undef TAKE
#undef TAKE_EACH
    if (nearer) packet->farthest = farthest_of(packet);
}

/// Ends the rays of such rows that meet a primitive of the block: their t_max becomes -1.
FUNCTION void block_ends_rays(Scene scene, const global Group *group, uint kind, uint block, uint rows, PacketRays *packet){
#define END(name, block, j, ray, r) ray->t_max = name##_crossing(block, j, *ray).hit ? (float16)(-1.0f) : ray->t_max
#define END_EACH(KIND, Record, name) MEET_EACH(KIND, Record, name, END)
    FOR_EACH_PRIMITIVE(END_EACH)
#undef END
#undef END_EACH
}

FUNCTION bool all_ended(const PacketRays *packet) {
    int16 alive = (int16)(0);
    FOR_EACH_ROW(r) alive |= packet->rows[r].t_max >= 0.0f;
    return mask_bits(alive) == 0u;
}
