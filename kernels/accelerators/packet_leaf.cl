// Blocks of primitives against a packet of 16 rays, one primitive after another.
#pragma once
#include "generated/primitives.cl"
#include "kernels/accelerators/packet_hits.cl"
#include "kernels/accelerators/primitive_hits_8.cl"
#include "kernels/core/bits.cl"
#include "kernels/core/items.cl"
#include "kernels/core/scene.cl"

#include "kernels/core/lanes_16.cl"
#include "generated/primitive_hits.cl"

#include "kernels/core/lanes_1.cl"

/// block_closest_hit for a packet.
FUNCTION void block_closest_hits(Scene scene, const global Group *group, uint kind, uint block, PacketRays *packet, PacketHits *hits) {
    ray_x16 *ray = &packet->rays;
    bool nearer = false;
#define CROSS_EACH(KIND, Record, name)                                                                                \
    if (kind == KIND) {                                                                                               \
        const global Record##Block *b = RECORDS(scene, Record##Block, group->blocks[KIND]) + block;                   \
        box_x8 box;                                                                                                   \
        name##_box(b, 0u, &box);                                                                                      \
        for (uint bits = candidates(packet, b->primitive, box); bits != 0u; bits &= bits - 1u) {                      \
            const uint j = lowest_bit(bits);                                                                          \
            const crossing_x16 crossing = name##_crossing(b, j, *ray);                                                \
            if (mask_bits(crossing.hit) == 0u) continue;                                                              \
            const uint16 primitive = (uint16)(b->primitive[j]);                                                       \
            const float16 t = INSTANCES ? maximum(crossing.t, hits->entry) : crossing.t;                              \
            const int16 better = crossing.hit & is_before(t, primitive, hits);                                        \
            const float16 other = better ? (hits->primitive == (uint16)(NO_HIT) ? (float16)(INFINITY) : hits->t) : t; \
            hits->next = crossing.hit ? minimum(hits->next, other) : hits->next;                                      \
            hits->t = better ? t : hits->t;                                                                           \
            hits->u = better ? crossing.u : hits->u;                                                                  \
            hits->v = better ? crossing.v : hits->v;                                                                  \
            hits->primitive = better ? primitive : hits->primitive;                                                   \
            if (INSTANCES) hits->instance = better ? (uint16)(hits->inside) : hits->instance;                         \
            ray->t_max = better ? t + hits->margin : ray->t_max;                                                      \
            nearer = true;                                                                                            \
        }                                                                                                             \
    }
    FOR_EACH_PRIMITIVE(CROSS_EACH)
#undef CROSS_EACH
    if (nearer) packet->farthest = largest_lane(ray->t_max);
}

/// Ends the rays that meet a primitive of the block: their t_max becomes -1.
FUNCTION void block_ends_rays(Scene scene, const global Group *group, uint kind, uint block, PacketRays *packet) {
    ray_x16 *ray = &packet->rays;
#define END_EACH(KIND, Record, name)                                                                     \
    if (kind == KIND) {                                                                                  \
        const global Record##Block *b = RECORDS(scene, Record##Block, group->blocks[KIND]) + block;      \
        box_x8 box;                                                                                      \
        name##_box(b, 0u, &box);                                                                         \
        for (uint bits = candidates(packet, b->primitive, box); bits != 0u; bits &= bits - 1u)           \
            ray->t_max = name##_crossing(b, lowest_bit(bits), *ray).hit ? (float16)(-1.0f) : ray->t_max; \
    }
    FOR_EACH_PRIMITIVE(END_EACH)
#undef END_EACH
}
