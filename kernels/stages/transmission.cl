// What transparent things let through of the light along shadow rays, which go straight on through them.
#pragma once
#include "kernels/accelerators/levels.cl"
#include "kernels/bsdfs/bsdf.cl"
#include "kernels/core/load.cl"
#include "kernels/core/refraction.cl"
#include "kernels/core/spawn.cl"
#include "kernels/primitives/placed.cl"
#include "kernels/stages/face_list.cl"

/// One face that the ray goes through: its material, and whether it is entered.
typedef struct {
    const global Material *material;
    bool enters;
    float t;
} Pane;

/// What a face lets through: nothing if it is opaque. Fresnel's law is that of the side with the lower index, so that a plate, both of whose faces
/// are met at the angle outside, lets through what it does in truth.
FUNCTION Spectrum pane_transmission(Pane pane, float cosine) {
    const float eta = minimum(pane.material->eta, 1.0f / pane.material->eta);
    return bsdf_split(pane.material, cosine, refracted_cosine_squared(cosine, eta), eta, false).refracted;
}

/// The product of all faces' transmissions, in the order of (t, instance, primitive), as any accelerator finds them. Neighbours in a mesh that share
/// the edge which the ray meets are one face. `passed` ends with the face that takes the rest of the light, if one does.
FUNCTION Spectrum transmission_along(Scene scene, Ray ray, uint source_instance, FaceList *passed) {
    Spectrum light = make3(1.0f, 1.0f, 1.0f);
    Pane last = {0, false, 0.0f};
    for (;;) {
        const ray_x8 lanes = prepare(ray, scene.header->world.extent);
        const float margin = crowd_margin(&lanes);
        HitList list = empty_list();
        scene_any_hit(scene, ray, source_instance, &list);
        Surface surface;
        for (uint k = 0u; k < list.count; ++k) {
            surface = surface_of(scene, ray, list.hits[k]);
            const float projection = dot3(surface.geometric, ray.direction);
            const Pane pane = {material_of(scene, list.hits[k]), projection < 0.0f, list.hits[k].hit.t};
            const bool known = pane.material == last.material && pane.enters == last.enters && pane.t - last.t <= margin;
            last = pane;
            if (known) continue;
            const Spectrum part = pane_transmission(pane, minimum(fabs(projection), 1.0f));
            if (passed && largest(light) > 0.0f) face_list_add(passed, list.hits[k], surface.p, pane.enters, part);
            light = times(light, part);
        }
        if (list.count < HIT_LIST_SIZE || largest(light) <= 0.0f) return light;
        const vec3 onward = scaled(surface.geometric, last.enters ? -1.0f : 1.0f);
        ray.origin = spawn_origin(surface.p, scaled(onward, dot3(absolute(onward), surface.error)));
        ray.t_max -= last.t;
        ray.tag = RAY_TAG(RAY_SHADOW, list.hits[list.count - 1u].hit.primitive);
        source_instance = instance_of(list.hits[list.count - 1u]);
        last.t = 0.0f;
    }
}
