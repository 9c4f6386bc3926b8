// Blocks of primitives against one ray, 8 at a time: what every accelerator's leaves call.
#pragma once
#include "generated/primitives.cl"
#include "kernels/accelerators/hits.cl"
#include "kernels/accelerators/primitive_hits_8.cl"
#include "kernels/core/bits.cl"
#include "kernels/core/items.cl"
#include "kernels/core/scene.cl"

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

/// How many there are.
FUNCTION uint block_size(Scene scene, const global Group *group, uint kind, uint block) {
    return popcount(mask_bits(*(const global uint8 *)block_numbers(scene, group, kind, block) != (uint8)(NO_HIT)));
}

/// A nearer crossing, or an equally near one of a primitive of lower number, replaces the hit and shortens the ray.
FUNCTION void block_closest_hit(Scene scene, const global Group *group, uint kind, uint block, ray_x8 *ray, Nearest *nearest) {
    Hit *hit = &nearest->hit;
    COUNT(ray, blocks, 1u), COUNT(ray, tests, block_size(scene, group, kind, block));
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
        } else if (!is_hit(primitive[j], nearest)) {
            nearest->next = minimum(nearest->next, t[j]);
        }
    }
    ray->t_max = (float8)(hit->t + nearest->margin);
}

/// Adds the block's hits to the list; without a list, tells whether there is any.
FUNCTION bool block_any_hit(Scene scene, const global Group *group, uint kind, uint block, const ray_x8 *ray, HitList *list) {
    COUNT(ray, blocks, 1u), COUNT(ray, tests, block_size(scene, group, kind, block));
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
