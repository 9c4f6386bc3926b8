// From hits to surface points.
#include "generated/interior.cl"
#include "kernels/core/load.cl"
#include "kernels/primitives/primitive.cl"

/// points[i] and frames[i] say where ray live[first + i] met the scene, and how; after a miss there is no SURFACE_HIT and only `wo` means anything.
kernel void evaluate_surfaces(SCENE_PARAMS, LIVE_PARAMS, const global Ray *restrict rays, const global Hit *restrict hits,
                              const global uint *restrict interiors, global SurfacePoint *restrict points,
                              global SurfaceFrame *restrict frames) {
    const Scene scene = SCENE;
    const global ShadingRecord *records = SCENE_ARRAY(scene, ShadingRecord, shading);
    const global Material *materials = SCENE_ARRAY(scene, Material, materials);
    const global uint *list = live + first;
    FOR_EACH_ITEM(i, count) {
        const uint k = list[i];
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

        const uint sides = enters ? SURFACE_ENTERS : transmits ? SURFACE_LIT_BEYOND : 0u;
        const uint lit = (material->flags & MATERIAL_LIT) != 0u ? SURFACE_LIT : 0u;
        SurfacePoint point;
        point.p = surface.p;
        point.material = on_surface ? record->material : 0u;
        point.offset = scaled(surface.geometric, side * dot3(absolute(surface.geometric), surface.error));
        point.flags = on_surface ? SURFACE_HIT | sides | lit | (hidden ? SURFACE_PASSES : 0u) : 0u;
        points[i] = point;

        SurfaceFrame frame;
        frame.normal = scaled(surface.normal, side);
        frame.eta = (enters | !transmits) ? around.eta / material->eta : material->eta / around.eta;
        frame.wo = negate(unit(ray.direction));
        frame.spare = 0u;
        frames[i] = frame;
    }
}
