// Which interface between media a ray has met, where transparent bodies overlap or touch. Only in scenes with transparent materials.
#include "generated/instances.cl"
#include "generated/interior.cl"
#include "kernels/accelerators/levels.cl"
#include "kernels/core/spawn.cl"
#include "kernels/primitives/primitive.cl"

/// A face that a ray meets: what it does to the list of media.
typedef struct {
    uint material;
    bool enters;
} Face;

FUNCTION Surface surface_of(Scene scene, Ray ray, PlacedHit hit) {
    const global ShadingRecord *record = SCENE_ARRAY(scene, ShadingRecord, shading) + hit.hit.primitive;
    const Ray inner = ray_in_group(scene, instance_of(hit), ray);
    return surface_in_world(scene, instance_of(hit), primitive_surface_serially(scene, record, inner, hit.hit));
}

FUNCTION uint material_index_of(Scene scene, PlacedHit hit) {
    return material_in_instance(scene, instance_of(hit), SCENE_ARRAY(scene, ShadingRecord, shading)[hit.hit.primitive].material);
}
FUNCTION const global Material *material_of(Scene scene, PlacedHit hit) {
    return SCENE_ARRAY(scene, Material, materials) + material_index_of(scene, hit);
}
FUNCTION bool transmits(Scene scene, PlacedHit hit) { return (material_of(scene, hit)->flags & MATERIAL_TRANSMITS) != 0u; }

/// Whether the point of the one lies on the other, within the errors of both.
FUNCTION bool coincide(Surface a, Surface b) {
    const vec3 n = absolute(a.geometric);
    return fabs(dot3(a.geometric, minus(b.p, a.p))) <= dot3(n, plus(a.error, b.error));
}

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

/// The faces of the hits; neighbours in a mesh that share the edge which the ray meets are one.
FUNCTION uint faces_of(Scene scene, Ray ray, const HitList *list, Face *faces) {
    uint count = 0u;
    for (uint k = 0u; k < list->count; ++k) {
        const PlacedHit hit = list->hits[k];
        const Face face = {material_index_of(scene, hit), dot3(surface_of(scene, ray, hit).geometric, ray.direction) < 0.0f};
        bool known = false;
        for (uint f = 0u; f < count; ++f) known |= faces[f].material == face.material && faces[f].enters == face.enters;
        if (!known) faces[count++] = face;
    }
    return count;
}

/// The closest hit, and what coincides with it.
FUNCTION HitList hits_at(Scene scene, Ray ray, uint source_instance, PlacedHit closest, bool crowded) {
    HitList list = empty_list();
    if (!crowded) {
        list.hits[0] = closest, list.count = 1u;
        return list;
    }
    const ray_x8 lanes = prepare(ray, scene.header->world.extent);
    ray.t_max = closest.hit.t + crowd_margin(&lanes);
    scene_any_hit(scene, ray, source_instance, &list);
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

/// An interface is one where the medium that counts changes; a ray passes all others straight on, so that hits[i], and rays[k] for its item k,
/// become those at the interface, with sources[k] and instances[i] as intersect has them, interiors[k] the media before it and beyond[i] those
/// behind. etas[i] is the index of refraction before it over that behind; at an opaque surface, over the material's. Rays passed on are counted with
/// refracted ones, one tally per work-item.
kernel void find_interfaces(SCENE_PARAMS, LIVE_PARAMS, global Ray *restrict rays, global uint *restrict sources, global Hit *restrict hits,
                            global uint *restrict instances, const global uchar *restrict crowded, global uint *restrict interiors,
                            global uint *restrict beyond, global float *restrict etas, volatile global uint *restrict lost,
                            global Tally *restrict tallies) {
    const Scene scene = SCENE;
    const global Material *materials = SCENE_ARRAY(scene, Material, materials);
    Tally tally = {{0u}, {0u}};
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const uint k = live[first + i];
        Ray ray = rays[k];
        uint source_instance = instance_at(sources, k);
        PlacedHit met = placed(hits[i], instance_at(instances, i));
        bool is_crowd = crowded[i] != 0;
        Interior inside = interior_load(interiors, k), behind = inside;
        float eta = 1.0f;
        while (met.hit.primitive != NO_HIT) {
            const HitList list = hits_at(scene, ray, source_instance, met, is_crowd);
            met = foremost(scene, &list);
            if (!transmits(scene, met)) {
                eta = interior_medium(inside, materials).eta / material_of(scene, met)->eta;
                break;
            }
            Face faces[HIT_LIST_SIZE];
            cross_faces(faces, faces_of(scene, ray, &list, faces), &inside, &behind, lost);
            const Medium here = interior_medium(inside, materials), there = interior_medium(behind, materials);
            eta = here.eta / there.eta;
            if (here.entry != there.entry) break;
            const Surface surface = surface_of(scene, ray, met);
            const vec3 onward = scaled(surface.geometric, dot3(surface.geometric, ray.direction) < 0.0f ? -1.0f : 1.0f);
            ray.origin = spawn_origin(surface.p, scaled(onward, dot3(absolute(onward), surface.error)));
            ray.tag = RAY_TAG(RAY_KIND(ray.tag), met.hit.primitive);
            source_instance = instance_of(met);
            inside = behind;
            const Nearest nearest = scene_closest_hit(scene, ray, source_instance);
            met = closest_of(nearest);
            is_crowd = is_crowded(nearest);
            tally.rays[RAY_REFRACTED] += 1u;
            tally.hits[RAY_REFRACTED] += met.hit.primitive != NO_HIT;
        }
        rays[k] = ray;
        hits[i] = met.hit;
        store_instance(sources, k, source_instance), store_instance(instances, i, instance_of(met));
        interior_store(interiors, k, inside);
        interior_store(beyond, i, behind);
        etas[i] = eta;
    }
    tallies[get_global_id(0)] = tally;
}
