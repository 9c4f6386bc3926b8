// Blocks of primitives against one ray, as many of a block at a time as the ray has lanes: what every accelerator's leaves call.
#pragma once
#include "generated/primitives.cl"
#include "generated/single_ray.cl"
#include "kernels/accelerators/hits.cl"
#include "kernels/core/bits.cl"
#include "kernels/core/items.cl"
#include "kernels/core/scene.cl"

/// As many primitives of a block as are tested at a time, from number `first` in it on; NO_HIT among the numbers ends a block.
#define FOR_EACH_PART(first, numbers) \
    for (uint first = 0u; first < BLOCK_SIZE && (SINGLE_LANES == BLOCK_SIZE || (numbers)[first] != NO_HIT); first += SINGLE_LANES)

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
FUNCTION uint block_size(const global uint *numbers) {
    uint size = 0u;
    while (size < BLOCK_SIZE && numbers[size] != NO_HIT) ++size;
    return size;
}

/// Of a part of a block.
FUNCTION SingleCrossing block_crossing(Scene scene, const global Group *group, uint kind, uint block, uint first, const SingleRay *ray) {
    SingleCrossing crossing;
    crossing.hit = 0;
#define CROSS(KIND, Record, name) \
    if (kind == KIND) crossing = name##_crossing(RECORDS(scene, Record##Block, group->blocks[KIND]) + block, first, *ray);
    FOR_EACH_PRIMITIVE(CROSS)
#undef CROSS
    return crossing;
}

/// What is met shortens the ray.
FUNCTION void block_closest_hit(Scene scene, const global Group *group, uint kind, uint block, SingleRay *ray, Nearest *nearest) {
    const global uint *numbers = block_numbers(scene, group, kind, block);
    COUNT(ray, blocks, 1u), COUNT(ray, tests, block_size(numbers));
    FOR_EACH_PART(first, numbers) {
        const SingleCrossing crossing = block_crossing(scene, group, kind, block, first, ray);
        uint bits = mask_bits(crossing.hit);
        if (bits == 0u) continue;
        float t[SINGLE_LANES], u[SINGLE_LANES], v[SINGLE_LANES];
        store_lanes(crossing.t, t), store_lanes(crossing.u, u), store_lanes(crossing.v, v);
        for (; bits != 0u; bits &= bits - 1u) {
            const uint j = lowest_bit(bits);
            meet(nearest, t[j], u[j], v[j], numbers[first + j]);
        }
        set_t_max(ray, nearest->hit.t + nearest->margin);
    }
}

/// Adds the block's hits to the list; without a list, tells whether there is any.
FUNCTION bool block_any_hit(Scene scene, const global Group *group, uint kind, uint block, const SingleRay *ray, HitList *list) {
    const global uint *numbers = block_numbers(scene, group, kind, block);
    COUNT(ray, blocks, 1u), COUNT(ray, tests, block_size(numbers));
    FOR_EACH_PART(first, numbers) {
        const SingleCrossing crossing = block_crossing(scene, group, kind, block, first, ray);
        uint bits = mask_bits(crossing.hit);
        if (bits == 0u) continue;
        if (list == 0) return true;
        float t[SINGLE_LANES], u[SINGLE_LANES], v[SINGLE_LANES];
        store_lanes(crossing.t, t), store_lanes(crossing.u, u), store_lanes(crossing.v, v);
        for (; bits != 0u; bits &= bits - 1u) {
            const uint j = lowest_bit(bits);
            const Hit hit = {INSTANCES ? maximum(t[j], list->entry) : t[j], u[j], v[j], numbers[first + j]};
            hit_list_add(list, hit);
        }
    }
    return false;
}
