// What a traversal of a packet gathers: as hits.cl has it, for 16 rays at once.
#pragma once
#include "kernels/accelerators/hits.cl"
#include "kernels/accelerators/packet.cl"

/// Nearest, lane by lane.
typedef struct {
    float16 t, u, v;
    uint16 primitive;
    float16 next, margin;
    uint16 instance;
    uint inside;
    float16 entry;
} PacketHits;

FUNCTION PacketHits packet_without_hits(const Packet *packet, float extent) {
    PacketHits hits;
    hits.t = packet->t_max, hits.u = (float16)(0.0f), hits.v = (float16)(0.0f), hits.primitive = (uint16)(NO_HIT);
    hits.next = (float16)(INFINITY);
    hits.margin = CROWD_MARGIN * box_pad(packet->origin, extent) / largest(absolute(packet->direction));
    if (INSTANCES) hits.instance = (uint16)(NO_HIT), hits.inside = 0u, hits.entry = (float16)(0.0f);
    return hits;
}

FUNCTION int16 is_before(float16 t, uint16 primitive, const PacketHits *hits) {
    const int16 first = primitive < hits->primitive;
    if (!INSTANCES) return (t < hits->t) | ((t == hits->t) & first);
    const uint16 inside = (uint16)(hits->inside);
    return (t < hits->t) | ((t == hits->t) & ((inside < hits->instance) | ((inside == hits->instance) & first)));
}
