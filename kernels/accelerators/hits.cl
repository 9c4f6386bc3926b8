// What a traversal of one ray gathers: the closest hit and whether it has company; or all hits up to some t.
// In scenes with instances it also knows which one it is in: `inside`, 0 outside of all, and `entry`, where the ray enters that one's box. A hit
// before the entry, which is due to rounding, is moved there, so that no box in the world can lose it.
#pragma once
#include "generated/constants.h"
#include "generated/instances.cl"
#include "kernels/accelerators/hit_list.h"
#include "kernels/core/ray_x1.cl"

/// The closest hit so far, and what else was met: where transparent bodies touch, a ray meets faces of both at one place.
typedef struct {
    Hit hit;
    float next, margin;  ///< t of the second hit, if it is at most `margin` behind; else anything beyond
    uint instance;       ///< that the hit is in
    uint inside;
    float entry;
    TIME_OF_HITS
} Nearest;

/// How far behind the closest hit others are looked for, over pad: coincident faces are that near even at grazing angles, where rounding of a plane
/// shifts t the more. find_interfaces decides by the faces' errors what does coincide. 0 in scenes without transparent materials.
#define CROWD_MARGIN (INTERIOR_SIZE > 0u ? 64.0f : 0.0f)

FUNCTION float crowd_margin(Ray ray, float extent) {
    return INTERIOR_SIZE > 0u ? CROWD_MARGIN * box_pad(ray.origin, extent) / largest(absolute(ray.direction)) : 0.0f;
}

/// `extent`: of the world.
FUNCTION Nearest nothing_hit(Ray ray, float extent) {
    Nearest nearest;
    nearest.hit = (Hit){ray.t_max, 0.0f, 0.0f, NO_HIT};
    nearest.next = INFINITY, nearest.margin = crowd_margin(ray, extent);
    nearest.instance = NO_HIT, nearest.inside = 0u, nearest.entry = 0.0f;
    return nearest;
}

/// Whether there is more than the closest hit.
FUNCTION bool is_crowded(Nearest nearest) { return nearest.hit.primitive != NO_HIT && nearest.next <= nearest.hit.t + nearest.margin; }

/// Whether a hit comes before the closest one in the order of (t, instance, primitive).
FUNCTION bool is_before(float t, uint primitive, const Nearest *nearest) {
    const Hit hit = nearest->hit;
    if (INSTANCES && t == hit.t && nearest->inside != nearest->instance) return nearest->inside < nearest->instance;
    return t < hit.t || (t == hit.t && primitive < hit.primitive);
}

/// Whether it is the closest hit's own primitive, met once more: structures with cells may test one twice.
FUNCTION bool is_hit(uint primitive, const Nearest *nearest) {
    return (primitive == nearest->hit.primitive) & (!INSTANCES | (nearest->inside == nearest->instance));
}

FUNCTION PlacedHit closest_of(Nearest nearest) {
    const uint instance = INSTANCES && nearest.hit.primitive != NO_HIT ? nearest.instance : 0u;
    return placed(nearest.hit, PLACEMENT(instance, nearest.time));
}

/// A nearer hit, or an equally near one of a primitive of lower number, replaces the closest one.
FUNCTION void meet(Nearest *nearest, float t, float u, float v, uint primitive) {
    Hit *hit = &nearest->hit;
    if (INSTANCES) t = maximum(t, nearest->entry);
    if (is_before(t, primitive, nearest)) {
        nearest->next = hit->primitive == NO_HIT ? INFINITY : hit->t;
        hit->t = t, hit->u = u, hit->v = v, hit->primitive = primitive;
        if (INSTANCES) nearest->instance = nearest->inside;
    } else if (!is_hit(primitive, nearest)) {
        nearest->next = minimum(nearest->next, t);
    }
}

/// The first few hits in the order of (t, instance, primitive).
typedef struct {
    PlacedHit hits[HIT_LIST_SIZE];
    uint count;
    uint inside;
    float entry;
    TIME_OF_HITS
} HitList;

FUNCTION HitList empty_list(void) {
    HitList list;
    list.count = 0u;
    if (INSTANCES) list.inside = 0u, list.entry = 0.0f;
    return list;
}

FUNCTION bool is_before(PlacedHit a, PlacedHit b) {
    if (a.hit.t != b.hit.t) return a.hit.t < b.hit.t;
    if (instance_of(a) != instance_of(b)) return instance_of(a) < instance_of(b);
    return a.hit.primitive < b.hit.primitive;
}

/// A hit that is in the list already does not come twice.
FUNCTION void hit_list_add(HitList *list, Hit hit) {
    PlacedHit added = placed(hit, PLACEMENT(list->inside, list->time));
    for (uint k = 0u; k < list->count; ++k) {
        const PlacedHit other = list->hits[k];
        if (is_before(other, added)) continue;
        if (!is_before(added, other)) return;
        list->hits[k] = added, added = other;
    }
    if (list->count < HIT_LIST_SIZE) list->hits[list->count++] = added;
}
