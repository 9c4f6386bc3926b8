// Brings hits together whose surfaces scatter light by one kind of BSDF, so that most chunks of the stages behind have one kind and do without the
// others' code. What has met nothing comes last. Only for paths in scenes with several kinds, on CPUs.
#include "generated/choosing.cl"
#include "generated/constants.h"
#include "kernels/core/bits.cl"
#include "kernels/core/items.cl"
#include "kernels/core/load.cl"
#include "kernels/primitives/placed.cl"

/// Chunks of hits that one work-item groups: the more, the fewer chunks have hits of two kinds.
#define CHUNKS_PER_GROUP 16u
#define HITS_PER_GROUP (CHUNKS_PER_GROUP * ITEMS_PER_CHUNK)
#define MISS 15u      ///< as a kind, above those of BSDFs
#define HIT_WORDS 4u  ///< of a Hit, the primitive last
#define MAX_WORDS 8u  ///< of a record: INTERIOR_SIZE is at most 8
#define PLACE_WORDS (INSTANCES ? INSTANCES_MOVE ? 2u : 1u : 0u)

FUNCTION bool is_ordered(const uchar *kinds, uint items) {
    for (uint c = 1u; c < items; ++c)
        if (kinds[c] < kinds[c - 1u]) return false;
    return true;
}

/// order[j]: which of the chunk's hits comes to its place j. Hits of one kind stay in their order. `present`: bits of the kinds that there are.
FUNCTION void order_by_kind(const uchar *kinds, uint items, uint present, ushort *order) {
    uint place = 0u;
    for (; present != 0u; present &= present - 1u) {
        const uint kind = lowest_bit(present);
        for (uint c = 0u; c < items; ++c) order[place] = (ushort)c, place += kinds[c] == kind;
    }
}

/// The chunk's part of an array of records of so many words, a constant up to MAX_WORDS.
FUNCTION void reorder(global uint *array, uint words, Chunk chunk, const ushort *order) {
    uint before[MAX_WORDS * HITS_PER_GROUP];
    global uint *records = array + chunk.begin * words;
    for (uint w = 0u; w < chunk.items * words; ++w) before[w] = records[w];
    for (uint c = 0u; c < chunk.items; ++c) {
        const uint *from = before + order[c] * words;
#pragma unroll
        for (uint w = 0u; w < words; ++w) records[c * words + w] = from[w];
    }
}

/// Changes the order of a list's items, and with it that of what stages have found out about them.
kernel void group_hits(SCENE_PARAMS, global uint *restrict live, uint first, uint count, global uint *restrict hits, global uint *restrict instances,
                       global uint *restrict beyond, global uint *restrict etas, global uint *restrict chosen) {
    const Scene scene = SCENE;
    const global ShadingRecord *records = SCENE_ARRAY(scene, ShadingRecord, shading);
    const global Material *materials = SCENE_ARRAY(scene, Material, materials);
    const Chunk chunk = chunks_of(count, CHUNKS_PER_GROUP);
    uchar kinds[HITS_PER_GROUP];
    uint present = 0u;
    SIXTEEN_WIDE for (uint c = 0u; c < chunk.items; ++c) {
        const uint i = chunk.begin + c, primitive = hits[i * HIT_WORDS + HIT_WORDS - 1u];
        const bool is_hit = primitive != NO_HIT;
        const uint own = material_in_instance(scene, instance_at(instances, i), records[is_hit ? primitive : 0u].material);
        const uint kind = is_hit ? materials[material_at_hit(chosen, i, own)].kind : MISS;
        kinds[c] = (uchar)kind;
        present |= 1u << kind;
    }
    if (is_ordered(kinds, chunk.items)) return;
    ushort order[HITS_PER_GROUP + 1u];
    order_by_kind(kinds, chunk.items, present, order);
    reorder(live + first, 1u, chunk, order);
    reorder(hits, HIT_WORDS, chunk, order);
    reorder(instances, PLACE_WORDS, chunk, order);
    if (TRANSMITS) {
        reorder(beyond, INTERIOR_SIZE, chunk, order);
        reorder(etas, 1u, chunk, order);
    }
    if (CHOOSES) reorder(chosen, 1u, chunk, order);
}
