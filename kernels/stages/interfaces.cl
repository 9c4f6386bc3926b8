// Interfaces: which of the faces that a ray meets is one between media, where transparent bodies overlap or touch.
#pragma once
#include "generated/interior.cl"
#include "kernels/accelerators/levels.cl"
#include "kernels/primitives/placed.cl"
#include "kernels/stages/face_list.cl"

/// A face that a ray meets: what it does to the list of media.
typedef struct {
    uint material;
    bool enters;
} Face;

FUNCTION bool transmits(Scene scene, PlacedHit hit) { return (material_of(scene, hit)->flags & MATERIAL_TRANSMITS) != 0u; }

/// Makes the list those hits that coincide with its first. What is opaque hides the others.
FUNCTION void keep_coincident(Scene scene, Ray ray, HitList *list) {
    const Surface first = surface_of(scene, ray, list->hits[0]);
    uint kept = 1u;
    for (uint k = 1u; k < list->count; ++k) {
        const PlacedHit hit = list->hits[k];
        if (coincide(first, surface_of(scene, ray, hit))) list->hits[kept++] = hit;
    }
    list->count = kept;
    for (uint k = 0u; k < kept; ++k) {
        if (transmits(scene, list->hits[k])) continue;
        list->hits[0] = list->hits[k], list->count = 1u;
        return;
    }
}

FUNCTION Face face_of(Scene scene, Ray ray, PlacedHit hit) {
    Face face;
    face.material = material_index_of(scene, hit);
    face.enters = dot3(surface_of(scene, ray, hit).geometric, ray.direction) < 0.0f;
    return face;
}

/// The faces of the hits; neighbours in a mesh that share the edge which the ray meets are one.
FUNCTION uint faces_of(Scene scene, Ray ray, const HitList *list, Face *faces) {
    uint count = 0u;
    for (uint k = 0u; k < list->count; ++k) {
        const Face face = face_of(scene, ray, list->hits[k]);
        bool known = false;
        for (uint f = 0u; f < count; ++f) known |= faces[f].material == face.material && faces[f].enters == face.enters;
        if (!known) faces[count++] = face;
    }
    return count;
}

/// The closest hit, and what coincides with it.
FUNCTION HitList hits_at(Scene scene, Ray ray, Placement source, PlacedHit closest) {
    HitList list = empty_list();
    ray.t_max = closest.hit.t + crowd_margin(ray, scene.header->world.extent);
    scene_any_hit(scene, ray, source, &list);
    keep_coincident(scene, ray, &list);
    return list;
}

/// The media on both sides of the faces. A ray that leaves what it never entered began inside of it.
/// `lost` counts media entered for which there is no place.
FUNCTION void cross_faces(const Face *faces, uint count, Interior *inside, Interior *beyond, volatile global uint *lost) {
    for (uint f = 0u; f < count; ++f)
        if (!faces[f].enters && !interior_contains(*inside, faces[f].material)) *inside = interior_entered(*inside, faces[f].material);
    *beyond = *inside;
    for (uint f = 0u; f < count; ++f) {
        *beyond = faces[f].enters ? interior_entered(*beyond, faces[f].material) : interior_left(*beyond, faces[f].material);
        if (faces[f].enters && !interior_contains(*beyond, faces[f].material)) atomic_inc(lost);
    }
}

/// Of coincident faces, the one whose medium counts most: the interface that there would be if the other body overlapped this one.
FUNCTION PlacedHit foremost(Scene scene, const HitList *list) {
    PlacedHit best = list->hits[0];
    for (uint k = 1u; k < list->count; ++k)
        if (material_of(scene, list->hits[k])->priority > material_of(scene, best)->priority) best = list->hits[k];
    return best;
}

/// A ray on its way to an interface.
typedef struct {
    Ray ray;
    Placement source;  ///< of the primitive that it leaves
    PlacedHit met;
    bool crowded;             ///< whether `met` has company
    Interior inside, behind;  ///< the media before and behind `met`
    float eta;                ///< index of refraction before it over that behind; at an opaque surface, over the material's
} Passage;

/// Index of refraction in these media over that of what is hit, which is opaque; 1 after a miss.
FUNCTION float eta_before(Scene scene, Interior inside, PlacedHit met) {
    if (met.hit.primitive == NO_HIT) return 1.0f;
    return interior_medium(inside, SCENE_ARRAY(scene, Material, materials)).eta / material_of(scene, met)->eta;
}

/// Sees what is on both sides of `met`. False where it is no interface, because the medium that counts stays.
FUNCTION bool is_interface(Scene scene, Passage *passage, volatile global uint *lost) {
    const global Material *materials = SCENE_ARRAY(scene, Material, materials);
    Face faces[HIT_LIST_SIZE];
    uint count = 1u;
    if (passage->crowded) {
        const HitList list = hits_at(scene, passage->ray, passage->source, passage->met);
        passage->met = foremost(scene, &list);
        count = faces_of(scene, passage->ray, &list, faces);
    } else {  // most are alone, and need no list
        faces[0] = face_of(scene, passage->ray, passage->met);
    }
    if (!transmits(scene, passage->met)) {
        passage->eta = eta_before(scene, passage->inside, passage->met);
        return true;
    }
    cross_faces(faces, count, &passage->inside, &passage->behind, lost);
    const Medium here = interior_medium(passage->inside, materials), there = interior_medium(passage->behind, materials);
    passage->eta = here.eta / there.eta;
    return here.entry != there.entry;
}

/// Goes straight on behind `met`, to what is next.
FUNCTION void pass_on(Scene scene, Passage *passage, FaceList *passed) {
    const Surface surface = surface_of(scene, passage->ray, passage->met);
    const bool enters = dot3(surface.geometric, passage->ray.direction) < 0.0f;
    if (passed) face_list_add(passed, passage->met, surface.p, enters, make3(1.0f, 1.0f, 1.0f));
    passage->ray = ray_behind(passage->ray, passage->met, surface);
    passage->source = place_of(passage->met);
    passage->inside = passage->behind;
    const Nearest nearest = scene_closest_hit(scene, passage->ray, passage->source);
    passage->met = closest_of(nearest);
    passage->crowded = is_crowded(nearest);
}

/// Follows a ray, from what it meets first on, to the first interface; `tally` counts what it does on its way with refracted rays.
FUNCTION void cross_to_interface(Scene scene, Passage *passage, volatile global uint *lost, Tally *tally, FaceList *passed) {
    while (passage->met.hit.primitive != NO_HIT && !is_interface(scene, passage, lost)) {
        pass_on(scene, passage, passed);
        tally->rays[RAY_REFRACTED] += 1u;
        tally->hits[RAY_REFRACTED] += passage->met.hit.primitive != NO_HIT;
    }
}

/// Of a ray in the media `inside`.
FUNCTION Passage passage_of(Ray ray, Placement source, PlacedHit met, bool crowded, Interior inside) {
    Passage passage;
    passage.ray = ray, passage.source = source;
    passage.met = met, passage.crowded = crowded;
    passage.inside = inside, passage.behind = inside, passage.eta = 1.0f;
    return passage;
}
