// Path tracing (Kajiya, SIGGRAPH 1986) with light asked at every surface, both ways of finding it weighted by Veach's power heuristic (thesis 1997,
// section 9.2); from the surface that the eye sees on in bundles, where there are some. The loop over these kernels is runtime/integrators/path.cpp.
#include "generated/constants.h"
#include "generated/instances.cl"
#include "generated/interior.cl"
#include "generated/tints.cl"
#include "kernels/bsdfs/emitted.cl"
#include "kernels/bsdfs/scattering.cl"
#include "kernels/core/columns.cl"
#include "kernels/core/frame.cl"
#include "kernels/core/load.cl"
#include "kernels/core/params.h"
#include "kernels/core/random.cl"
#include "kernels/core/scene.cl"
#include "kernels/core/sides.cl"
#include "kernels/core/spawn.cl"
#include "kernels/integrators/bundle.cl"
#include "kernels/lights/choice.cl"
#include "kernels/lights/light.cl"
#include "kernels/samplers/slot.cl"

// A path's uses of its sampler at each surface.
#define USE_DIRECTION 1u
#define USE_CHOICES 2u
#define USE_LIGHT 3u
#define USE_ROULETTE 4u
#define USES_PER_SURFACE 4u

/// The weight of what was found with the density a, where the other way would have found it with the density b, given b / a.
FUNCTION float power_heuristic(float ratio) { return 1.0f / fma(ratio, ratio, 1.0f); }

/// Around the shading normal, or the geometric one where the shading normal faces away from wo.
FUNCTION Frame frame_of(Sides sides, vec3 wo) { return frame_of(where(dot3(sides.normal, wo) > 0.0f, sides.normal, sides.geometric)); }

/// A surface that a path has met.
typedef struct {
    const global Material *material;
    SurfacePoint at;
    Sides sides;
    Frame frame;      ///< of `point`
    BsdfPoint point;  ///< as its BSDF sees it
    bool is_there;    ///< else the path has left the scene, and nothing here means anything
} MetSurface;

FUNCTION MetSurface met_surface(const global Material *materials, SurfacePoint at, SurfaceInterface interface, Tints tint, vec3 wo) {
    MetSurface met;
    met.material = materials + at.material, met.at = at;
    met.sides = sides_of(at, interface);
    met.frame = frame_of(met.sides, wo);
    met.point.wo = to_frame(met.frame, wo), met.point.eta = interface.eta;
    met.point.diffuse_tint = tint.diffuse, met.point.specular_tint = tint.specular;
    met.is_there = (at.flags & SURFACE_HIT) != 0u;
    return met;
}

/// Whether a direction, whose component along the frame's axis is z, leads to the same side of the surface itself as of the shading normal's plane.
FUNCTION bool on_its_side(Sides sides, vec3 direction, float z) { return dot3(sides.geometric, direction) * z > 0.0f; }

/// Whether light may come from there. Where shading normals reflect towards the wrong side of a face, the smooth surface decides, from which the ray
/// begins: if it is not lifted enough to pass its own face, it meets that.
FUNCTION bool may_come_from(MetSurface met, vec3 direction, float z) {
    const bool opaque = !TRANSMITS || (met.material->flags & MATERIAL_TRANSMITS) == 0u;
    return (SHADING_NORMALS && opaque && z > 0.0f) || on_its_side(met.sides, direction, z);
}

/// What a ray in such a direction leaves, and so cannot meet.
FUNCTION uint source_of(MetSurface met, vec3 direction, float z) {
    return !SHADING_NORMALS || on_its_side(met.sides, direction, z) ? SURFACE_PRIMITIVE(met.at.flags) : NO_HIT;
}

/// A path behind its next surface.
typedef struct {
    Ray ray;
    Path path;
    float pdf;    ///< of the ray's direction, as of BsdfSample, times the rays that go on for each that asks for light
    bool enters;  ///< what is behind the surface
    bool lives;
} NextPath;

/// In the direction `next`, unless chance ends it by `u` in [0, 1).
FUNCTION NextPath next_path(MetSurface met, Path path, BundleRow row, BsdfSample next, uint roulette_depth, float u) {
    const bool stays = next.wi.z > 0.0f, single = next.pdf == INFINITY;
    const vec3 scattered = from_frame(met.frame, next.wi), outwards = scaled(met.sides.geometric, stays ? 1.0f : -1.0f);
    // The shading normal may lead the only direction of a mirror to the wrong side of the surface: then its mirror image at the surface counts.
    const vec3 wi = unit(SHADING_NORMALS && single ? folded(scattered, outwards) : scattered);
    NextPath child;
    child.enters = !stays && TRANSMITS && (met.material->flags & MATERIAL_TRANSMITS) != 0u;
    // Radiance in a medium of index n has a factor n², which must not count as brightness.
    const float scale = child.enters ? 1.0f / (met.point.eta * met.point.eta) : 1.0f;
    const float survival = row.surface >= roulette_depth ? minimum(largest(next.weight) * scale, 1.0f) : 1.0f;
    child.path = path;
    child.path.depth = depth_word(row.surface + 1u, part_within(row.path, row.going));
    child.path.throughput = scaled(times(path.throughput, next.weight), survival > 0.0f ? share_of(row.going) / survival : 0.0f);
    child.path.branch = hash(path.branch * 2u + row.going.number);
    const vec3 origin = where(stays, met.sides.near, met.sides.far);
    child.ray = ray_spawn(origin, wi, stays ? RAY_REFLECTED : RAY_REFRACTED, source_of(met, wi, next.wi.z));
    child.pdf = next.pdf * ratio_of_counts(row);
    child.lives = (met.is_there & may_come_from(met, wi, next.wi.z)) && u < survival && largest(child.path.throughput) > 0.0f &&
                  row.going.number < row.going.count;
    return child;
}

/// A ray that asks whether a light is visible.
typedef struct {
    Ray ray;
    Spectrum added;  ///< to the path's sample, if it is
    bool is_worth;
} AskingRay;

/// For this sample of the chosen light, weighted against the chance that the BSDF finds the same.
FUNCTION AskingRay asking_ray(MetSurface met, Path path, BundleRow row, ChosenLight chosen, LightSample sample) {
    const vec3 towards = to_frame(met.frame, sample.direction);
    const BsdfValue value = bsdf_eval(met.material, met.point, towards);
    const float weight = power_heuristic(value.pdf * inverse_light_density(chosen, sample) * ratio_of_counts(row)) * share_of(row.asking);
    const Spectrum received = scaled(times(value.value, sample.irradiance), chosen.inverse_chance * weight);
    const vec3 origin = where(towards.z > 0.0f, met.sides.near, met.sides.far);
    AskingRay asking;
    asking.ray = ray_to_light(origin, sample.ray_direction, sample.distance, source_of(met, sample.direction, towards.z));
    asking.added = times(path.throughput, received);
    asking.is_worth =
        (met.is_there & may_come_from(met, sample.direction, towards.z)) && largest(asking.added) > 0.0f && row.asking.number < row.asking.count;
    return asking;
}

/// What a chunk's paths have chosen.
typedef struct {
    uint light[ITEMS_PER_WORK_ITEM];            ///< its row
    float inverse_chance[ITEMS_PER_WORK_ITEM];  ///< as of ChosenLight
    float radiance[ITEMS_PER_WORK_ITEM];
    float lobe[ITEMS_PER_WORK_ITEM];  ///< in [0, 1), of the material, before it is divided among a bundle
} ChosenColumns;

/// From live item i, in row j of its bundle: the ray that goes on, in slot base + j * count + i, in the medium that it is in then, with the density
/// `child_pdfs` of its direction; and shadow ray j * stride + i, with what the light that it asks adds to the sample where it is visible. No ray
/// leaves for a black value, nor in rows beyond the bundle. `surface` is the number of the surfaces on their paths, from 1 on.
kernel void spawn_path(SCENE_PARAMS, PathParams params, uint surface, BatchParams batch, const global uint *restrict pixels, LIVE_PARAMS,
                       const global Path *restrict paths, const global SurfacePoint *restrict points,
                       const global SurfaceInterface *restrict interfaces, const global vec3 *restrict directions,
                       const global uint *restrict instances, const global Tints *restrict tints, const global uint *restrict interiors,
                       const global uint *restrict beyond, const global ushort *restrict scene_texels, uint base, uint stride,
                       global Ray *restrict children, global Path *restrict child_paths, global float *restrict child_pdfs,
                       global uint *restrict child_sources, global uint *restrict child_interiors, global uchar *restrict child_alive,
                       global Ray *restrict shadow_rays, global Spectrum *restrict shadow_light, global uchar *restrict shadow_alive) {
    const Scene scene = SCENE_WITH_TEXELS;
    const global Material *materials = SCENE_ARRAY(scene, Material, materials);
    const global uint *list = live + first;
    const uint number = BUNDLES ? get_global_id(1) : 0u, first_slot = base + number * count, first_shadow = number * stride;
    global Ray *first_rays = children + first_slot;
    global Path *first_paths = child_paths + first_slot;
    global float *first_pdfs = child_pdfs + first_slot;
    global uchar *first_alive = child_alive + number * count;
    const Chunk chunk = chunk_of(count);
    if (BUNDLES && is_beyond_bundles(materials, points, chunk, number, params.bundles)) {
        for (uint c = 0u; c < chunk.items; ++c) first_alive[chunk.begin + c] = 0;
        return;
    }
    uint numbers[ITEMS_PER_WORK_ITEM];
    list_numbers(list, chunk, numbers);
    Columns chunk_paths, chunk_lights;
    fetch_columns(paths, 6u, numbers, chunk.items, &chunk_paths);
    const uint uses = (surface - 1u) * USES_PER_SURFACE;
    ChosenColumns chosen;
    {
        FOR_EACH_ITEM(i, count) {
            const uint c = i - chunk.begin;
            const Path path = path_of_columns(&chunk_paths, c);
            const PixelSample which = pixel_sample(path.slot, batch, pixels);
            const vec2 choices = sampler_pair(which.pixel, which.sample, part_of(path), uses + USE_CHOICES, batch);
            chosen.lobe[c] = choices.x;
            if (LIGHTS) {
                const ChosenLight light = light_chosen(scene, place_of_part(bundle_row(path, surface, number, 0u, params.bundles).asking, choices.y));
                chosen.light[c] = light.row, chosen.inverse_chance[c] = light.inverse_chance, chosen.radiance[c] = light.radiance;
            }
        }
    }
    for (uint c = chunk.items; c < ITEMS_PER_WORK_ITEM; ++c) chosen.light[c] = 0u;
    if (LIGHTS) fetch_columns(SCENE_ARRAY(scene, Light, lights), 16u, chosen.light, chunk.items, &chunk_lights);
    FOR_EACH_ITEM(i, count) {
        const uint k = list[i], c = i - chunk.begin;
        const Path path = path_of_columns(&chunk_paths, c);
        const MetSurface met = met_surface(materials, load(points + i), load(interfaces + i), tints_at(tints, i), load(directions + i));
        const PixelSample which = pixel_sample(path.slot, batch, pixels);
        const BundleRow row = bundle_row(path, surface, number, met.material->flags, params.bundles);
        const Part going = part_within(row.path, row.going);
        const vec2 direction_pair = sampler_pair(which.pixel, which.sample, going, uses + USE_DIRECTION, batch);
        const float roulette = sampler_pair(which.pixel, which.sample, going, uses + USE_ROULETTE, batch).x;

        const BsdfSample next = bsdf_sample(met.material, met.point, direction_pair, place_of_part(row.going, chosen.lobe[c]));
        const NextPath child = next_path(met, path, row, next, params.roulette_depth, roulette);
        interior_choose(!child.enters, interiors, k, beyond, i, child_interiors, first_slot + i);
        store_instance(child_sources, first_slot + i, instance_at(instances, i));
        first_rays[i] = child.ray;
        first_paths[i] = child.path;
        first_pdfs[i] = child.pdf;
        first_alive[i] = child.lives;

        if (LIGHTS) {
            const ChosenLight light = {chosen.light[c], chosen.inverse_chance[c], chosen.radiance[c]};
            const vec2 square = sampler_pair(which.pixel, which.sample, part_within(row.path, row.asking), uses + USE_LIGHT, batch);
            LightRandom random = light_random(square, path.branch + number);
            SET_TIME(random, instance_at(instances, i).time);
            const LightSample sample = light_sample(scene, light_of_columns(&chunk_lights, c), met.at.origin, random);
            const AskingRay asking = asking_ray(met, path, row, light, sample);
            shadow_rays[first_shadow + i] = asking.ray;
            shadow_light[first_shadow + i] = asking.added;
            shadow_alive[first_shadow + i] = asking.is_worth && surface <= params.max_depth;
        }
    }
}

/// What a ray carries of what shines where it ends. It is weighted against the light that its origin has asked, where the surface there chose the
/// ray's direction with density `pdf`.
FUNCTION Spectrum met_light(Scene scene, uint first_generation, Ray ray, float pdf, Placement place, SurfacePoint surface, SurfaceInterface interface,
                            vec3 wo, Tints tint) {
    const bool asked = LIGHTS && first_generation == 0u;
    if ((surface.flags & SURFACE_HIT) == 0u) {
        const Spectrum radiance = times(scene.header->background, tint.diffuse);
        return asked ? scaled(radiance, power_heuristic(environment_density(scene, negate(wo)) / pdf)) : radiance;
    }
    const Spectrum radiance = emitted(SCENE_ARRAY(scene, Material, materials) + surface.material, surface.flags);
    if (!asked) return radiance;
    const ShadingRecord record = SCENE_ARRAY(scene, ShadingRecord, shading)[SURFACE_PRIMITIVE(surface.flags)];
    const vec3 straight = minus(surface.origin, ray.origin);
    const float density = emission_density(scene, record, place, radiance, ray.origin, surface.origin, interface.geometric,
                                           sqrt(dot3(straight, straight)), dot3(interface.geometric, wo));
    return scaled(radiance, power_heuristic(density / pdf));
}

/// contributions[i]: what ray i adds to its sample by the light that the surface where it ends asks, in `rows` rows of so many entries, as far as
/// `visible` says; and, of few rays, by what shines there.
kernel void shade_path(SCENE_PARAMS, uint first_generation, LIVE_PARAMS, const global Ray *restrict rays, const global Path *restrict paths,
                       const global float *restrict pdfs, const global uint *restrict instances, const global SurfacePoint *restrict points,
                       const global SurfaceInterface *restrict interfaces, const global vec3 *restrict directions, const global Tints *restrict tints,
                       uint rows, uint stride, const global uchar *restrict visible, const global Spectrum *restrict shadow_light,
                       global Spectrum *restrict contributions) {
    const Scene scene = SCENE;
    const global Material *materials = SCENE_ARRAY(scene, Material, materials);
    const Spectrum black = make3(0.0f, 0.0f, 0.0f);
    {
        FOR_EACH_ITEM(i, count) {
            const bool lit = (rows != 0u) && visible[i] != 0;
            contributions[i] = where(lit, load(shadow_light + i), black);
        }
    }
    if (BUNDLES) add_further_rows(count, rows, stride, visible, shadow_light, contributions);
    FOR_EACH_ITEM_SERIALLY(i, count) {
        if ((points[i].flags & SURFACE_HIT) != 0u && (materials[points[i].material].flags & MATERIAL_SHINES) == 0u) continue;
        const uint k = live[first + i];
        const Spectrum met = met_light(scene, first_generation, rays[k], pdfs[k], instance_at(instances, i), points[i], interfaces[i], directions[i],
                                       tints_at(tints, i));
        if (largest(met) > 0.0f) contributions[i] = plus(times(met, paths[k].throughput), contributions[i]);
    }
}
