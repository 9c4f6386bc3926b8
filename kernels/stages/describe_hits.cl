// What is told of hits when a pixel is inspected. Never part of a render.
#include "generated/constants.h"
#include "kernels/bsdfs/bsdf.cl"
#include "kernels/bsdfs/emitted.cl"
#include "kernels/core/load.cl"
#include "kernels/core/refraction.cl"
#include "kernels/primitives/placed.cl"
#include "kernels/stages/describe_hits.h"

/// Of hits[i] of rays[i], which is one, in instances[i] where the scene has some, with etas[i] the ratio of indices there, and
/// materials[i] the material.
kernel void describe_hits(SCENE_PARAMS, const global Ray *restrict rays, const global Hit *restrict hits, const global uint *restrict instances,
                          const global float *restrict etas, const global uint *restrict materials, uint count,
                          global HitDescription *restrict descriptions) {
    const Scene scene = SCENE;
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const Ray ray = rays[i];
        const PlacedHit hit = placed(hits[i], instance_at(instances, i));
        const global Material *material = SCENE_ARRAY(scene, Material, materials) + materials[i];
        const Surface surface = surface_of(scene, ray, hit);
        const bool enters = dot3(surface.geometric, ray.direction) < 0.0f;
        const vec3 wo = negate(unit(ray.direction));
        HitDescription description;
        description.p = surface.p, description.error = surface.error;
        description.geometric = surface.geometric, description.normal = surface.normal;
        description.cosine = minimum(maximum(dot3(wo, scaled(surface.normal, enters ? 1.0f : -1.0f)), 0.0f), 1.0f);
        description.cosine_squared_beyond = refracted_cosine_squared(description.cosine, etas[i]);
        description.emission = emitted(material, enters ? 0u : SURFACE_BACK);
        const Spectrum ambient = times(scene.header->ambient, bsdf_ambient(material));
        description.ambient = where(PATHS, make3(0.0f, 0.0f, 0.0f), ambient);
        descriptions[i] = description;
    }
}
