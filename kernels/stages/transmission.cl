// What transparent things let through of the light along shadow rays, which go straight on through them.
#pragma once
#include "kernels/accelerators/levels.cl"
#include "kernels/bsdfs/bsdf.cl"
#include "kernels/core/load.cl"
#include "kernels/core/refraction.cl"
#include "kernels/primitives/placed.cl"
#include "kernels/stages/face_list.cl"

/// One face that the ray goes through: its material, and whether it is entered.
typedef struct {
    const global Material *material;
    bool enters;
    Surface surface;
} Pane;

/// What a face lets through: nothing if it is opaque. Fresnel's law is that of the side with the lower index, so that a plate, both of whose faces
/// are met at the angle outside, lets through what it does in truth.
FUNCTION Spectrum pane_transmission(Pane pane, float cosine) {
    const float eta = minimum(pane.material->eta, 1.0f / pane.material->eta);
    return bsdf_split(pane.material, cosine, refracted_cosine_squared(cosine, eta), eta, false).refracted;
}

FUNCTION Pane pane_at(Scene scene, Ray ray, PlacedHit hit) {
    const Surface surface = surface_of(scene, ray, hit);
    const Pane pane = {material_of(scene, hit), dot3(surface.geometric, ray.direction) < 0.0f, surface};
    return pane;
}

/// Neighbours in a mesh that share the edge which the ray meets are one.
FUNCTION bool are_one(Pane a, Pane b) { return a.material == b.material && a.enters == b.enters && coincide(a.surface, b.surface); }

/// The product of all faces' transmissions, in the order of (t, instance, primitive), as any accelerator finds them. `passed` ends with the face that
/// takes the rest of the light, if one does. Of what a ray can cross twice a list of hits has but the first crossing: it is good up to the first such
/// thing, and what coincides with that; the rest is looked for from behind it.
FUNCTION Spectrum transmission_along(Scene scene, Ray ray, Placement source, FaceList *passed) {
    Spectrum light = make3(1.0f, 1.0f, 1.0f);
    Pane last, behind;
    last.material = 0;
    for (;;) {
        HitList list = empty_list();
        scene_any_hit(scene, ray, source, &list);
        const bool all = list.count < HIT_LIST_SIZE;
        bool flat = true;
        uint from = 0u;
        for (uint k = 0u; k < list.count; ++k) {
            const Pane pane = pane_at(scene, ray, list.hits[k]), before = last;
            if (!flat && !coincide(behind.surface, pane.surface)) break;
            last = pane;
            if (flat) behind = pane, from = k;
            flat &= is_flat(scene, list.hits[k]);
            if (are_one(pane, before)) continue;
            const Spectrum part = pane_transmission(pane, minimum(fabs(dot3(pane.surface.geometric, ray.direction)), 1.0f));
            if (passed && largest(light) > 0.0f) face_list_add(passed, list.hits[k], pane.surface.p, pane.enters, part);
            light = times(light, part);
        }
        if ((all && flat) || largest(light) <= 0.0f) return light;
        source = place_of(list.hits[from]);
        ray = ray_behind(ray, list.hits[from], behind.surface);
    }
}
