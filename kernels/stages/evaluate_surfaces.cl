// From hits to surface points.
#include "generated/interior.cl"
#include "kernels/core/load.cl"
#include "kernels/primitives/primitive.cl"

/// surfaces[i] is where ray live[first + i] met the scene; after a miss it has no SURFACE_HIT and only `wo` means anything.
kernel void evaluate_surfaces(SCENE_PARAMS, LIVE_PARAMS, const global Ray *restrict rays, const global Hit *restrict hits,
                              const global uint *restrict interiors, global SurfacePoint *restrict surfaces) {
    const Scene scene = SCENE;
    const global ShadingRecord *records = SCENE_ARRAY(scene, ShadingRecord, shading);
    const global Material *materials = SCENE_ARRAY(scene, Material, materials);
    FOR_EACH_ITEM(i, count) {
        const uint k = live[first + i];
        const Ray ray = load(rays + k);
        const Hit hit = load(hits + i);
        const bool on_surface = hit.primitive != NO_HIT;
        const global ShadingRecord *record = records + (on_surface ? hit.primitive : 0u);
        const Surface surface = primitive_surface(scene, record, ray, hit);
        const bool enters = dot3(surface.geometric, ray.direction) < 0.0f;
        const float side = enters ? 1.0f : -1.0f;

        const global Material *material = materials + record->material;
        const bool transmits = (material->flags & MATERIAL_TRANSMITS) != 0u;
        const Interior inside = interior_load(interiors, k);
        const Interior others = where(enters, inside, interior_left(inside, record->material));
        const Medium around = interior_medium(others, materials);
        const bool hidden = transmits & around.any & ((around.priority > material->priority) | interior_contains(others, record->material));
        const float eta_around = around.eta, eta_inside = material->eta;

        SurfacePoint point;
        point.p = surface.p;
        point.material = on_surface ? record->material : 0u;
        point.offset = scaled(surface.geometric, side * dot3(absolute(surface.geometric), surface.error));
        const uint sides = enters ? SURFACE_ENTERS : transmits ? SURFACE_LIT_BEYOND : 0u;
        point.flags = on_surface ? SURFACE_HIT | sides | (hidden ? SURFACE_PASSES : 0u) : 0u;
        point.normal = scaled(surface.normal, side);
        point.eta = (enters | !transmits) ? eta_around / eta_inside : eta_inside / eta_around;
        point.wo = negate(unit(ray.direction));
        point.spare = 0u;
        surfaces[i] = point;
    }
}
