// From hits to surface points.
#include "generated/choosing.cl"
#include "generated/constants.h"
#include "generated/instances.cl"
#include "generated/interior.cl"
#include "kernels/core/columns.cl"
#include "kernels/core/load.cl"
#include "kernels/core/spawn.cl"
#include "kernels/primitives/primitive.cl"

/// Where ray live[first + i] met the scene; wo[i] is the unit vector back along it. After a miss there is no SURFACE_HIT, and only wo[i] means
/// anything. etas[i] is the ratio of indices there, where scenes have transparent materials; instances[i] that of the hit, where they have some;
/// chosen[i] the material there, where some choose among others.
kernel void evaluate_surfaces(SCENE_PARAMS, LIVE_PARAMS, const global Ray *restrict rays, const global Hit *restrict hits,
                              const global uint *restrict instances, const global float *restrict etas, const global uint *restrict chosen,
                              global SurfacePoint *restrict points, global SurfaceInterface *restrict interfaces, global vec3 *restrict wo) {
    const Scene scene = SCENE;
    const global ShadingRecord *records = SCENE_ARRAY(scene, ShadingRecord, shading);
    const global Material *materials = SCENE_ARRAY(scene, Material, materials);
    const Chunk chunk = chunk_of(count);
    uint numbers[ITEMS_PER_WORK_ITEM], primitives[ITEMS_PER_WORK_ITEM];
    list_numbers(live + first, chunk, numbers);
    for (uint c = 0u; c < ITEMS_PER_WORK_ITEM; ++c) {
        const uint primitive = c < chunk.items ? hits[chunk.begin + c].primitive : NO_HIT;
        primitives[c] = primitive != NO_HIT ? primitive : 0u;
    }
    Columns chunk_rays, chunk_records;
    fetch_columns(rays, 8u, numbers, chunk.items, &chunk_rays);
    fetch_columns(records, 16u, primitives, chunk.items, &chunk_records);
    PlaceColumns chunk_places;
    fetch_places(scene, instances, chunk, &chunk_places);
    FOR_EACH_ITEM(i, count) {
        const Ray ray = ray_of_columns(&chunk_rays, i - chunk.begin);
        const Hit hit = load(hits + i);
        const bool on_surface = (hit.primitive != NO_HIT) & (hit.t >= 0.0f);  // reads the whole record: see SurfacePoint
        const ShadingRecord record = shading_of_columns(&chunk_records, i - chunk.begin);
        const Placement place = instance_at(instances, i);
        const PlacedTransforms transforms = transforms_of_columns(scene, instances, i, &chunk_places, i - chunk.begin);
        const Surface surface = surface_in_world(transforms, primitive_surface(scene, record, ray_in_group(transforms, ray), hit));
        const bool enters = dot3(surface.geometric, ray.direction) < 0.0f;
        const float side = enters ? 1.0f : -1.0f;

        const uint material_index = material_at_hit(chosen, i, material_in_instance(scene, place, record.material));
        const global Material *material = materials + material_index;
        const bool transmits = (material->flags & MATERIAL_TRANSMITS) != 0u;
        const bool lit_beyond = transmits & !enters;
        const float lit_side = lit_beyond ? -side : side;
        const vec3 geometric = scaled(surface.geometric, lit_side);
        const vec3 offset = scaled(geometric, dot3(absolute(geometric), surface.error));
        const uint beyond = lit_beyond ? SURFACE_LIT_BEYOND : 0u, back = enters ? 0u : SURFACE_BACK;
        const uint lit = (material->flags & MATERIAL_LIT) != 0u ? SURFACE_LIT : 0u;
        const bool is_lifted = PATHS && SHADING_NORMALS && !transmits;
        SurfacePoint point;
        point.origin = spawn_origin(is_lifted ? plus(surface.p, surface.lift) : surface.p, offset);
        point.material = on_surface ? material_index : 0u;
        point.normal = scaled(surface.normal, lit_side);
        point.flags = on_surface ? SURFACE_HIT | beyond | lit | back | hit.primitive << 4 : 0u;
        points[i] = point;

        SurfaceInterface interface;
        interface.beyond = spawn_origin(surface.p, negate(offset));
        interface.geometric = geometric;
        interface.eta = interface_eta(etas, i, material);
        interfaces[i] = interface;
        wo[i] = negate(unit(ray.direction));
    }
}
