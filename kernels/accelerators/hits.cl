// What a traversal gathers: the closest hit and whether it has company, for one ray and for packets; or all hits up to some t.
#pragma once
#include "generated/constants.h"
#include "kernels/accelerators/packet.cl"

/// The closest hit so far, and what else was met: where transparent bodies touch, a ray meets faces of both at one place.
typedef struct {
    Hit hit;
    float next, margin;  ///< t of the second hit, if it is at most `margin` behind; else anything beyond
} Nearest;

/// How far behind the closest hit others are looked for, over pad: coincident faces are that near even at grazing angles, where rounding of a plane
/// shifts t the more. find_interfaces decides by the faces' errors what does coincide. 0 in scenes without transparent materials.
#define CROWD_MARGIN (INTERIOR_SIZE > 0u ? 64.0f : 0.0f)

FUNCTION float crowd_margin(const ray_x8 *ray) { return CROWD_MARGIN * ray->pad.s0 / largest(absolute(ray->direction)).s0; }

FUNCTION Nearest nothing_hit(const ray_x8 *ray) {
    const Nearest nearest = {{ray->t_max.s0, 0.0f, 0.0f, NO_HIT}, INFINITY, crowd_margin(ray)};
    return nearest;
}

/// Whether there is more than the closest hit.
FUNCTION bool is_crowded(Nearest nearest) { return nearest.hit.primitive != NO_HIT && nearest.next <= nearest.hit.t + nearest.margin; }

/// Nearest, lane by lane.
typedef struct {
    float16 t, u, v;
    uint16 primitive;
    float16 next, margin;
} PacketHits;

FUNCTION PacketHits packet_without_hits(const Packet *packet, float extent) {
    PacketHits hits;
    hits.t = packet->t_max, hits.u = (float16)(0.0f), hits.v = (float16)(0.0f), hits.primitive = (uint16)(NO_HIT);
    hits.next = (float16)(INFINITY);
    hits.margin = CROWD_MARGIN * box_pad(packet->origin, extent) / largest(absolute(packet->direction));
    return hits;
}

#define HIT_LIST_SIZE 8u
/// The first few hits in the order of (t, primitive).
typedef struct {
    Hit hits[HIT_LIST_SIZE];
    uint count;
} HitList;

FUNCTION void hit_list_add(HitList *list, Hit hit) {
    for (uint k = 0u; k < list->count; ++k) {
        const Hit other = list->hits[k];
        if (hit.t > other.t || (hit.t == other.t && hit.primitive > other.primitive)) continue;
        list->hits[k] = hit, hit = other;
    }
    if (list->count < HIT_LIST_SIZE) list->hits[list->count++] = hit;
}
