// The cells of an octree along a ray, in integers: once the ray is rounded to the octree's units, which cells it comes to is decided without any
// further rounding.
//
// After Spackman and Willis, The SMART Navigation of a Ray Through an Oct-tree (Computers and Graphics 15(2) 1991), as others describe it, since the
// paper was not at hand: a ray's decisions are integers, made once from its direction and place, and go from a node to its children by adding the
// direction, shifted by the depth. What differs:
// - A ray is thick. It comes to all cells within `reach` of it, which is more than its pad (lane_ray.cl) and the rounding to units, so that no cell
//   is missed which holds what `none` finds. Planes are entered before they are left; hence six decisions for a cell, one for every two axes a, b:
//   (where a is entered) - (where b is left), times both components of the direction, which is 0 or less if the ray is in both slabs at once.
// - From a node the ray goes to all children that it meets, by eight lanes of such sums, lowest first, and back by a stack of what is left; the
//   paper's steps to a neighbour and back up need none, but one decision per step.
// - The ray has an end, in units too: what begins behind the nearest hit is left out.
#pragma once
#include "kernels/accelerators/octree.h"
#include "kernels/core/bits.cl"
#include "kernels/core/rays.cl"

#define OCTREE_FAR (1 << 25)  ///< stands for all that is farther: a ray begins there only if its pad exceeds the whole octree

/// In units, 2^-OCTREE_BITS of the root's side; signed.
typedef struct {
    int x, y, z;
} Units3;

/// Decision ab: (lower plane of a - origin of a - reach) * direction of b - (upper plane of b - origin of b + reach) * direction of a.
typedef struct {
    long xy, yx, xz, zx, yz, zy;
} Decisions;

/// A node on the way to where the walk is.
typedef struct {
    uint node, children;  ///< its number; bits of its children that the walk has not come to yet
    Units3 low;           ///< lower planes - origin - reach
    Decisions decisions;
} OctreeLevel;

/// The ray goes towards higher coordinates: axes along which it does not are reflected in the middle of the root.
typedef struct {
    OctreeLevel levels[OCTREE_DEPTH + 2u];  ///< node 0, which has the root as its lowest child, and down from it
    const global Octree *octree;
    const global OctreeNode *nodes;
    uint depth;        ///< of the level at hand
    uint flip;         ///< bits of the axes that are reflected
    Units3 origin;     ///< where the ray enters the root, or begins
    Units3 direction;  ///< the longest component is 2^29 to 2^30
    Units3 end;        ///< - origin
    int reach;
    float t_max;  ///< that `end` is of
} CellWalk;

/// From the root's lower corner, or its upper one on reflected axes.
FUNCTION int to_units(float p, float low, float unit, bool reflected) {
    const float units = (p - low) / unit, placed = reflected ? (float)OCTREE_UNITS - units : units;
    return (int)minimum(maximum(placed, -(float)OCTREE_FAR), (float)OCTREE_FAR);
}

FUNCTION Units3 place_at(const CellWalk *walk, const ray_x8 *ray, float t) {
    const global Octree *octree = walk->octree;
    Units3 place;
#define PLACE(x, bit) place.x = to_units(fma(t, ray->direction.x.s0, ray->origin.x.s0), octree->low.x, octree->unit, (walk->flip & bit) != 0u)
    PLACE(x, 1u), PLACE(y, 2u), PLACE(z, 4u);
#undef PLACE
    return place;
}

/// Where the ray ends now.
FUNCTION void set_end(CellWalk *walk, const ray_x8 *ray) {
    walk->t_max = ray->t_max.s0;
    Units3 end = {OCTREE_FAR, OCTREE_FAR, OCTREE_FAR};
    if (walk->t_max < INFINITY) end = place_at(walk, ray, walk->t_max);
    walk->end.x = end.x - walk->origin.x, walk->end.y = end.y - walk->origin.y, walk->end.z = end.z - walk->origin.z;
}

/// Magnitudes, scaled by a power of two and rounded: over the length of the root that is off by less than a unit.
FUNCTION Units3 integer_direction(vec3x8 d) {
    const float x = fabs(d.x.s0), y = fabs(d.y.s0), z = fabs(d.z.s0);
    const float power = as_float(as_uint(maximum(maximum(x, y), z)) & 0x7f800000u);  // 2^floor(log2)
    const Units3 direction = {(int)(x / power * 0x1p29f + 0.5f), (int)(y / power * 0x1p29f + 0.5f), (int)(z / power * 0x1p29f + 0.5f)};
    return direction;
}

/// Twice the pad, for its own rounding and that of the ray's places, and the rounding to units of both ends and of the direction.
FUNCTION int reach_of(const ray_x8 *ray, float unit) { return (int)minimum(2.0f * ray->pad.s0 / unit, 2.0f * (float)OCTREE_FAR) + 5; }

/// Bits of the children, of side `size`, that the ray meets, all of it behind its origin.
FUNCTION uint children_met(const OctreeLevel *level, Units3 direction, int size, int reach) {
    const long8 x = (long8)(0, -1, 0, -1, 0, -1, 0, -1), y = (long8)(0, 0, -1, -1, 0, 0, -1, -1), z = (long8)(0, 0, 0, 0, -1, -1, -1, -1);
    const long dx = (long)direction.x * size, dy = (long)direction.y * size, dz = (long)direction.z * size;
    const Decisions *of = &level->decisions;
    // The upper child of a has its lower plane `size` higher than the node, the lower child of b its upper plane as much lower.
#define BOTH(ab, a, b, da, db) ((a & db) + (~b & da) <= -of->ab)
    const long8 in_slabs = BOTH(xy, x, y, dx, dy) & BOTH(yx, y, x, dy, dx) & BOTH(xz, x, z, dx, dz) & BOTH(zx, z, x, dz, dx) &
                           BOTH(yz, y, z, dy, dz) & BOTH(zy, z, y, dz, dy);
#undef BOTH
    const long upper = size + 2 * (long)reach;
#define AHEAD(a) ((a & (long)size) >= -(level->low.a + upper))
    return mask_bits(convert_int8(in_slabs & AHEAD(x) & AHEAD(y) & AHEAD(z)));
#undef AHEAD
}

FUNCTION void cell_walk_begin(CellWalk *walk, const global CellSpans *spans, const ray_x8 *ray) {
    const global Octree *octree = (const global Octree *)spans;
    walk->octree = octree;
    walk->t_max = ray->t_max.s0;
    walk->nodes = (const global OctreeNode *)((const global uint *)spans + spans->cells);
    walk->depth = 0u;
    OctreeLevel *level = walk->levels;
    level->node = 0u;
    const float side = (float)OCTREE_UNITS * octree->unit;
#define LOW(x) fma(octree->low.x, ray->inverse.x.s0, ray->shift_low.x.s0)
#define HIGH(x) fma(octree->low.x + side, ray->inverse.x.s0, ray->shift_high.x.s0)
    const float enter = maximum(maximum(minimum(LOW(x), HIGH(x)), minimum(LOW(y), HIGH(y))), maximum(minimum(LOW(z), HIGH(z)), 0.0f));
    const float leave = minimum(minimum(maximum(LOW(x), HIGH(x)), maximum(LOW(y), HIGH(y))), minimum(maximum(LOW(z), HIGH(z)), ray->t_max.s0));
#undef LOW
#undef HIGH
    level->children = enter <= leave;
    if (level->children == 0u) return;

    walk->flip = (ray->direction.x.s0 < 0.0f ? 1u : 0u) | (ray->direction.y.s0 < 0.0f ? 2u : 0u) | (ray->direction.z.s0 < 0.0f ? 4u : 0u);
    walk->reach = reach_of(ray, octree->unit);
    walk->origin = place_at(walk, ray, enter);
    walk->direction = integer_direction(ray->direction);
    set_end(walk, ray);
    const int reach = walk->reach;
    const Units3 d = walk->direction, low = {-walk->origin.x - reach, -walk->origin.y - reach, -walk->origin.z - reach};
    level->low = low;
    const long above = 2 * (long)OCTREE_UNITS + 2 * (long)reach;
#define DECISION(a, b) (long)low.a *d.b - (low.b + above) * d.a
    level->decisions.xy = DECISION(x, y), level->decisions.yx = DECISION(y, x);
    level->decisions.xz = DECISION(x, z), level->decisions.zx = DECISION(z, x);
    level->decisions.yz = DECISION(y, z), level->decisions.zy = DECISION(z, y);
#undef DECISION
}

/// The child's level, below its parent's.
FUNCTION void descend(CellWalk *walk, uint node, uint child, Units3 low) {
    const OctreeLevel *parent = walk->levels + walk->depth;
    OctreeLevel *level = walk->levels + ++walk->depth;
    const int size = (int)(2u * OCTREE_UNITS >> walk->depth);
    const Units3 d = walk->direction;
    level->node = node, level->low = low;
    // As in children_met.
    const long x = -(long)(child & 1u), y = -(long)(child >> 1 & 1u), z = -(long)(child >> 2);
#define DECIDE(ab, a, b) level->decisions.ab = parent->decisions.ab + ((a & d.b) + (~b & d.a)) * size
    DECIDE(xy, x, y), DECIDE(yx, y, x), DECIDE(xz, x, z), DECIDE(zx, z, x), DECIDE(yz, y, z), DECIDE(zy, z, y);
#undef DECIDE
    level->children = children_met(level, d, size / 2, walk->reach);
}

/// Children come in the order of their numbers, since the ray goes towards higher coordinates.
FUNCTION uint cell_walk_next(CellWalk *walk, const ray_x8 *ray) {
    if (ray->t_max.s0 != walk->t_max) set_end(walk, ray);
    for (;;) {
        OctreeLevel *level = walk->levels + walk->depth;
        if (level->children == 0u) {
            if (walk->depth == 0u) return NO_ITEMS;
            --walk->depth;
            continue;
        }
        const uint child = lowest_bit(level->children);
        level->children &= level->children - 1u;
        const int size = (int)(OCTREE_UNITS >> walk->depth);
        const Units3 low = {level->low.x + (int)(child & 1u) * size, level->low.y + (int)(child >> 1 & 1u) * size,
                            level->low.z + (int)(child >> 2) * size};
        if (low.x > walk->end.x || low.y > walk->end.y || low.z > walk->end.z) continue;
        const uint word = walk->nodes[level->node].child[child ^ walk->flip];
        COUNT(ray, steps, 1u), COUNT(ray, cells, (word & OCTREE_LEAF) != 0u), COUNT(ray, empty_cells, word == NO_ITEMS);
        if (word == NO_ITEMS) continue;
        if ((word & OCTREE_LEAF) != 0u) return word & ~OCTREE_LEAF;
        descend(walk, word, child, low);
    }
}
