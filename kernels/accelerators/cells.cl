// Template, included once per level: LEVEL(name) names its functions, the LEAF_ macros test one block.
// What a ray meets in the cells that it comes through, for every structure that divides space: it gives `CellWalk`, the ray's way; cell_walk_begin(),
// and cell_walk_next(), the list of the next cell in which there is something, or NO_ITEMS at the end, which is where the ray is at its t_max.
//
// A hit counts wherever it lies, in this cell, before it or beyond: what is nearer shortens the ray, and so the walk ends only when the ray enters no
// cell before the hit. `none` finds a hit only if the ray meets the primitive's own box, grown by the pad, say at t (lane_ray.cl), and never before
// that t. A primitive is listed wherever its box has a part, and the walk comes to every cell that the ray meets within its pad, so to one that has
// the part of the box where the ray is at t; it has not ended then, since the hit is not nearer than t.
#include "kernels/accelerators/mailbox.cl"

#define CELL_SPANS (RECORDS(scene, CellSpans, group->nodes))
#define CELL_WORDS(place) ((const global uint *)CELL_SPANS + CELL_SPANS->place)
#define COUNT_LISTED(i) COUNT(ray, listed, popcount((uint)((const global uchar *)CELL_WORDS(lanes))[i]))

static void LEVEL(closest_hit)(Scene scene, const global Group *group, ray_x8 *ray, Nearest *nearest) {
    const global uint *items = CELL_WORDS(items);
    Mailbox mailbox;
    mailbox_empty(&mailbox);
    CellWalk walk;
    cell_walk_begin(&walk, CELL_SPANS, ray);
    for (;;) {
        uint i = cell_walk_next(&walk, ray);
        if (i == NO_ITEMS) return;
        for (;; ++i) {
            const uint item = items[i] & ~ITEM_LAST;
            COUNT_LISTED(i);
            if (mailbox_add(&mailbox, item)) LEAF_CLOSEST_HIT(scene, group, item >> ITEM_KIND_SHIFT, item & ITEM_BLOCK, ray, nearest);
            if (item != items[i]) break;
        }
    }
}

/// Adds all hits up to the ray's t_max to the list; without a list, tells whether there is any.
static bool LEVEL(any_hit)(Scene scene, const global Group *group, const ray_x8 *ray, HitList *list) {
    const global uint *items = CELL_WORDS(items);
    Mailbox mailbox;
    mailbox_empty(&mailbox);
    CellWalk walk;
    cell_walk_begin(&walk, CELL_SPANS, ray);
    for (;;) {
        uint i = cell_walk_next(&walk, ray);
        if (i == NO_ITEMS) return false;
        for (;; ++i) {
            const uint item = items[i] & ~ITEM_LAST;
            COUNT_LISTED(i);
            if (mailbox_add(&mailbox, item) && LEAF_ANY_HIT(scene, group, item >> ITEM_KIND_SHIFT, item & ITEM_BLOCK, ray, list)) return true;
            if (item != items[i]) break;
        }
    }
}
#undef COUNT_LISTED
#undef CELL_WORDS
#undef CELL_SPANS
