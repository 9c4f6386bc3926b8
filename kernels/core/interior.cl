// Which transparent objects a ray is inside of: a side array of INTERIOR_SIZE entries per ray (Schmidt & Budge, JGT 7(2) 2002).
#pragma once
#include "generated/constants.h"
#include "kernels/core/scene.cl"

/// An entry is (material + 1) << 8 | how often it was entered; 0 is free.
typedef struct {
    uint entries[INTERIOR_SIZE];
} Interior;

#define FOR_EACH_ENTRY(k) _Pragma("unroll") for (uint k = 0u; k < INTERIOR_SIZE; ++k)

FUNCTION Interior interior_load(const global uint *interiors, uint slot) {
    Interior interior;
    FOR_EACH_ENTRY(k) interior.entries[k] = interiors[slot * INTERIOR_SIZE + k];
    return interior;
}
FUNCTION void interior_store(global uint *interiors, uint slot, Interior interior) {
    FOR_EACH_ENTRY(k) interiors[slot * INTERIOR_SIZE + k] = interior.entries[k];
}

FUNCTION void interior_copy(const global uint *from, uint i, global uint *to, uint k) { interior_store(to, k, interior_load(from, i)); }

/// The list of `either` at i, or if not `c` of `other` at j.
FUNCTION void interior_choose(bool c, const global uint *either, uint i, const global uint *other, uint j, global uint *to, uint k) {
    FOR_EACH_ENTRY(e) to[k * INTERIOR_SIZE + e] = c ? either[i * INTERIOR_SIZE + e] : other[j * INTERIOR_SIZE + e];
}

FUNCTION bool interior_contains(Interior interior, uint material) {
    bool found = false;
    FOR_EACH_ENTRY(k) found |= interior.entries[k] >> 8 == material + 1u;
    return found;
}

FUNCTION Interior interior_entered(Interior interior, uint material) {
    bool placed = interior_contains(interior, material);
    FOR_EACH_ENTRY(k) {
        const uint entry = interior.entries[k];
        const uint once_more = entry >> 8 == material + 1u ? entry + 1u : entry;
        interior.entries[k] = ((entry == 0u) & !placed) ? (material + 1u) << 8 | 1u : once_more;
        placed |= entry == 0u;
    }
    return interior;
}

FUNCTION Interior interior_left(Interior interior, uint material) {
    FOR_EACH_ENTRY(k) {
        const uint entry = interior.entries[k];
        const uint once_less = (entry & 0xffu) == 1u ? 0u : entry - 1u;
        interior.entries[k] = entry >> 8 == material + 1u ? once_less : entry;
    }
    return interior;
}

/// The medium that counts: the entry of the highest priority, of the lowest number among equals.
typedef struct {
    float eta;
    uint entry;  ///< material + 1; 0: outside of everything, eta is 1
} Medium;

FUNCTION Medium interior_medium(Interior interior, const global Material *materials) {
    Medium medium = {1.0f, 0u};
    uint highest = 0u;
    FOR_EACH_ENTRY(k) {
        const uint entry = interior.entries[k] >> 8;
        const global Material *material = materials + (max(entry, 1u) - 1u);
        const bool first = (entry < medium.entry) | (medium.entry == 0u);
        const bool better = (entry != 0u) & ((material->priority > highest) | ((material->priority == highest) & first));
        medium.eta = better ? material->eta : medium.eta;
        medium.entry = better ? entry : medium.entry;
        highest = better ? material->priority : highest;
    }
    return medium;
}
#undef FOR_EACH_ENTRY

/// What find_interfaces has found out for item i.
FUNCTION float interface_eta(const global float *etas, uint i, const global Material *material) { return etas[i]; }

/// That is over the index of the hit's own material: 1 of one that chooses, in whose place another counts.
FUNCTION void store_eta_of_chosen(global float *etas, uint i, const global Material *chosen) { etas[i] /= chosen->eta; }
