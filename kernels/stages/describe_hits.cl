// What is told of hits when a pixel is inspected. Never part of a render.
#include "kernels/bsdfs/bsdf.cl"
#include "kernels/core/load.cl"
#include "kernels/core/refraction.cl"
#include "kernels/primitives/primitive.cl"
#include "kernels/stages/describe_hits.h"

/// Of hits[i] of rays[i], which is one, with etas[i] the ratio of indices there.
kernel void describe_hits(SCENE_PARAMS, const global Ray *restrict rays, const global Hit *restrict hits, const global float *restrict etas, uint count,
                          global HitDescription *restrict descriptions) {
    const Scene scene = SCENE;
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const Ray ray = rays[i];
        const global ShadingRecord *record = SCENE_ARRAY(scene, ShadingRecord, shading) + hits[i].primitive;
        const global Material *material = SCENE_ARRAY(scene, Material, materials) + record->material;
        const Surface surface = primitive_surface_serially(scene, record, ray, hits[i]);
        const bool enters = dot3(surface.geometric, ray.direction) < 0.0f;
        const vec3 wo = negate(unit(ray.direction));
        HitDescription description;
        description.p = surface.p, description.error = surface.error;
        description.geometric = surface.geometric, description.normal = surface.normal;
        description.cosine = minimum(maximum(dot3(wo, scaled(surface.normal, enters ? 1.0f : -1.0f)), 0.0f), 1.0f);
        description.cosine_squared_beyond = refracted_cosine_squared(description.cosine, etas[i]);
        description.emission = load(&material->emission);
        description.ambient = times(scene.header->ambient, bsdf_ambient(material));
        descriptions[i] = description;
    }
}
