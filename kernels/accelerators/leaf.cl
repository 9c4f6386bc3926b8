// Blocks of primitives against one ray (8 primitives at a time) or a packet of 16 rays: what every accelerator's leaves call.
#pragma once
#include "generated/primitives.cl"
#include "kernels/accelerators/hits.cl"
#include "kernels/accelerators/packet.cl"
#include "kernels/core/bits.cl"
#include "kernels/core/items.cl"
#include "kernels/core/scene.cl"

#include "kernels/core/lanes_8.cl"
#include "generated/primitive_hits.cl"

#include "kernels/core/lanes_16.cl"
#include "generated/primitive_hits.cl"

#include "kernels/core/lanes_1.cl"

#define CROSS_BLOCK(KIND, Record, name) \
    if (kind == KIND) crossing = name##_crossing(RECORDS(scene, Record##Block, group->blocks[KIND]) + block, 0u, *ray);

/// Numbers of a block's primitives.
FUNCTION const global uint *block_numbers(Scene scene, const global Group *group, uint kind, uint block) {
    const global uint *numbers = 0;
#define CASE(KIND, Record, name) \
    if (kind == KIND) numbers = (RECORDS(scene, Record##Block, group->blocks[KIND]) + block)->primitive;
    FOR_EACH_PRIMITIVE(CASE)
#undef CASE
    return numbers;
}

/// A nearer crossing, or an equally near one of a primitive of lower number, replaces the hit and shortens the ray.
FUNCTION void block_closest_hit(Scene scene, const global Group *group, uint kind, uint block, ray_x8 *ray, Nearest *nearest) {
    Hit *hit = &nearest->hit;
    crossing_x8 crossing;
    crossing.hit = (int8)(0);
    FOR_EACH_PRIMITIVE(CROSS_BLOCK)
    uint bits = mask_bits(crossing.hit);
    if (bits == 0u) return;
    const global uint *primitive = block_numbers(scene, group, kind, block);
    float t[8], u[8], v[8];
    vstore8(INSTANCES ? maximum(crossing.t, (float8)(nearest->entry)) : crossing.t, 0, t);
    vstore8(crossing.u, 0, u), vstore8(crossing.v, 0, v);
    for (; bits != 0u; bits &= bits - 1u) {
        const uint j = lowest_bit(bits);
        if (is_before(t[j], primitive[j], nearest)) {
            nearest->next = hit->primitive == NO_HIT ? INFINITY : hit->t;
            hit->t = t[j], hit->u = u[j], hit->v = v[j], hit->primitive = primitive[j];
            if (INSTANCES) nearest->instance = nearest->inside;
        } else {
            nearest->next = minimum(nearest->next, t[j]);
        }
    }
    ray->t_max = (float8)(hit->t + nearest->margin);
}

/// Adds the block's hits to the list; without a list, tells whether there is any.
FUNCTION bool block_any_hit(Scene scene, const global Group *group, uint kind, uint block, const ray_x8 *ray, HitList *list) {
    crossing_x8 crossing;
    crossing.hit = (int8)(0);
    FOR_EACH_PRIMITIVE(CROSS_BLOCK)
    uint bits = mask_bits(crossing.hit);
    if (list == 0 || bits == 0u) return bits != 0u;
    const global uint *primitive = block_numbers(scene, group, kind, block);
    float t[8], u[8], v[8];
    vstore8(INSTANCES ? maximum(crossing.t, (float8)(list->entry)) : crossing.t, 0, t);
    vstore8(crossing.u, 0, u), vstore8(crossing.v, 0, v);
    for (; bits != 0u; bits &= bits - 1u) {
        const uint j = lowest_bit(bits);
        const Hit hit = {t[j], u[j], v[j], primitive[j]};
        hit_list_add(list, hit);
    }
    return false;
}
#undef CROSS_BLOCK

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
