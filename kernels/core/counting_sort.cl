// Sorting by small keys, those of one key staying in their order: count the keys, then place one item after another.
#pragma once
#include "kernels/core/portable.h"

/// Of keys below `key_count`, `next` has key_count + 1 entries: here the counts of none.
FUNCTION void count_no_keys(uint *next, uint key_count) {
    for (uint k = 0u; k <= key_count; ++k) next[k] = 0u;
}

FUNCTION void count_key(uint *next, uint key) { next[key + 1u] += 1u; }

/// After all are counted. next[key]: where the items of this key begin in the order of keys; next[key_count] is the count of all.
FUNCTION void begin_keys(uint *next, uint key_count) {
    for (uint k = 1u; k <= key_count; ++k) next[k] += next[k - 1u];
}

/// The place of the next item, which has this key.
FUNCTION uint place_of_next(uint *next, uint key) { return next[key]++; }
