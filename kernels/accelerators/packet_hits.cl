// What a traversal of a packet gathers: as hits.cl has it, for rows of 16 rays.
#pragma once
#include "kernels/accelerators/hits.cl"
#include "kernels/accelerators/packet.cl"

/// Nearest, lane by lane.
typedef struct {
    float16 t, u, v;
    uint16 primitive;
    float16 next, margin;
    uint16 instance;
    float16 entry;
} RowHits;

typedef struct {
    RowHits rows[ROWS];
    uint inside;
} PacketHits;

FUNCTION RowHits row_without_hits(const Row *row, float extent) {
    RowHits hits;
    hits.t = row->t_max, hits.u = (float16)(0.0f), hits.v = (float16)(0.0f), hits.primitive = (uint16)(NO_HIT);
    hits.next = (float16)(INFINITY);
    hits.margin = (float16)(0.0f);
    if (INTERIOR_SIZE > 0u) hits.margin = CROWD_MARGIN * box_pad(row->origin, extent) / largest(absolute(row->direction));
    if (INSTANCES) hits.instance = (uint16)(NO_HIT), hits.entry = (float16)(0.0f);
    return hits;
}

FUNCTION PacketHits packet_without_hits(const Packet *packet, float extent) {
    PacketHits hits;
    hits.inside = 0u;
    FOR_EACH_ROW(r) hits.rows[r] = row_without_hits(&packet->rows[r], extent);
    return hits;
}

/// `inside`: the instance that the row is in.
FUNCTION int16 is_before(float16 t, uint16 primitive, uint inside, const RowHits *hits) {
    const int16 first = primitive < hits->primitive;
    if (!INSTANCES) return (t < hits->t) | ((t == hits->t) & first);
    const uint16 here = (uint16)(inside);
    return (t < hits->t) | ((t == hits->t) & ((here < hits->instance) | ((here == hits->instance) & first)));
}

/// Takes what a row's rays meet at the crossing with a primitive, and ends them there; false if none meets it.
FUNCTION bool take_crossing(crossing_x16 crossing, uint number, uint inside, ray_x16 *ray, RowHits *hits) {
    if (mask_bits(crossing.hit) == 0u) return false;
    const uint16 primitive = (uint16)(number);
    const float16 t = INSTANCES ? maximum(crossing.t, hits->entry) : crossing.t;
    const int16 better = crossing.hit & is_before(t, primitive, inside, hits);
    const float16 other = better ? (hits->primitive == (uint16)(NO_HIT) ? (float16)(INFINITY) : hits->t) : t;
    hits->next = crossing.hit ? minimum(hits->next, other) : hits->next;
    hits->t = better ? t : hits->t;
    hits->u = better ? crossing.u : hits->u;
    hits->v = better ? crossing.v : hits->v;
    hits->primitive = better ? primitive : hits->primitive;
    if (INSTANCES) hits->instance = better ? (uint16)(inside) : hits->instance;
    ray->t_max = better ? t + hits->margin : ray->t_max;
    return true;
}
