// What transparent things let through of the light along shadow rays, which go straight on through them. Only on request, in scenes that have some.
#include "kernels/accelerators/levels.cl"
#include "kernels/bsdfs/bsdf.cl"
#include "kernels/core/load.cl"
#include "kernels/core/refraction.cl"
#include "kernels/core/spawn.cl"
#include "kernels/primitives/placed.cl"

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
/// the edge which the ray meets are one face.
FUNCTION Spectrum transmission_along(Scene scene, Ray ray, uint source_instance) {
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
            if (!known) light = times(light, pane_transmission(pane, minimum(fabs(projection), 1.0f)));
            last = pane;
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

/// Work-items (chunk, row), after trace_shadow_rays and with its lists. filters[k] is what arrives of the light along ray k: all of it where
/// visible[k] is set, for nothing was met; elsewhere visible[k] becomes 1 if anything arrives.
kernel void filter_shadow_rays(SCENE_PARAMS, const global uint *restrict live, const global uint *restrict counts, uint stride,
                               const global Ray *restrict rays, const global uint *restrict instances, global uchar *restrict visible,
                               global Spectrum *restrict filters) {
    const Scene scene = SCENE;
    const uint row = get_global_id(1);
    const global uint *list = live + row * stride;
    FOR_EACH_ITEM_SERIALLY(i, counts[row]) {
        const uint k = list[i];
        const Spectrum light =
            visible[k] != 0 ? make3(1.0f, 1.0f, 1.0f) : transmission_along(scene, rays[k], instance_at(instances, k - row * stride));
        filters[k] = light;
        visible[k] = largest(light) > 0.0f;
    }
}
