// What is told of paths when a pixel is inspected: what integrators/path.cl has chosen at their surfaces, and why. Never part of a render.
#include "kernels/stages/describe_paths.h"
#include "kernels/integrators/asking.cl"
#include "kernels/integrators/met_light.cl"
#include "kernels/integrators/next_path.cl"
#include "kernels/integrators/path_columns.cl"

FUNCTION MetDescription describe_met(Scene scene, bool is_weighted, Ray ray, float pdf, Placement place, SurfacePoint point,
                                     SurfaceInterface interface, vec3 wo, Tints tint) {
    MetDescription met;
    if ((point.flags & SURFACE_HIT) == 0u) {
        met.radiance = times(scene.header->background, tint.diffuse);
        met.weight = background_weight(scene, is_weighted, pdf, wo);
        return met;
    }
    met.radiance = emitted(SCENE_ARRAY(scene, Material, materials) + point.material, point.flags);
    met.weight = largest(met.radiance) > 0.0f ? met_weight(scene, is_weighted, met.radiance, ray, pdf, place, point, interface, wo) : 1.0f;
    return met;
}

FUNCTION NextDescription describe_next(MetSurface met, BundleRow row, BsdfSample sample, NextPath next, float roulette) {
    NextDescription description;
    description.ray = next.ray, description.weight = next.path.throughput;
    description.scattered = sample.weight, description.pdf = sample.pdf;
    description.survival = next.survival, description.roulette = roulette;
    const uint absorbed = largest(sample.weight) > 0.0f ? 0u : PATH_ABSORBED;
    const uint across = may_come_from(met, next.ray.direction, sample.wi.z) ? 0u : PATH_ACROSS;
    const uint ended = roulette < next.survival ? 0u : PATH_ENDED;
    description.refusals = absorbed | across | ended | (row.going.number < row.going.count ? 0u : PATH_NO_PART);
    return description;
}

FUNCTION uint asked_refusals(MetSurface met, LightSample sample, float z, BsdfValue value) {
    const bool is_black = largest(value.value) <= 0.0f;
    const uint shown = is_there(met) ? 0u : LIGHT_NOT_SHOWN;
    const uint faces = is_black && z <= 0.0f ? LIGHT_BEHIND : 0u;
    const uint sends = largest(sample.irradiance) > 0.0f ? 0u : LIGHT_SENDS_NOTHING;
    return shown | faces | sends | (may_come_from(met, sample.direction, z) ? 0u : LIGHT_ACROSS) | (is_black ? LIGHT_NOT_SCATTERED : 0u);
}

FUNCTION AskedDescription describe_asked(MetSurface met, ChosenLight chosen, LightSample sample, float z, BsdfValue value, AskingRay asking) {
    AskedDescription description;
    description.row = chosen.row, description.chance = 1.0f / chosen.inverse_chance;
    description.irradiance = sample.irradiance, description.inverse_density = inverse_light_density(chosen, sample);
    description.cosine = z, description.value = value.value, description.pdf = value.pdf;
    description.weight = asking.weight, description.radiance = asking.added;
    description.refusals = asked_refusals(met, sample, z, value);
    return description;
}

/// Work-items (chunk, row), with the arguments of spawn_path, but that the paths have throughput 1. Of live item i: what its ray, which was chosen
/// with density pdfs[live[first + i]], brings of itself; and in row j of its bundle how it goes on and the light that it asks, both at j * count + i.
kernel void describe_paths(SCENE_PARAMS, PathParams params, uint surface, BatchParams batch, const global uint *restrict pixels, LIVE_PARAMS,
                           const global Ray *restrict rays, const global Path *restrict paths, const global float *restrict pdfs,
                           const global SurfacePoint *restrict points, const global SurfaceInterface *restrict interfaces,
                           const global vec3 *restrict directions, const global uint *restrict instances, const global Tints *restrict tints,
                           const global Texel *restrict scene_texels, global MetDescription *restrict met_light,
                           global NextDescription *restrict next, global AskedDescription *restrict asked) {
    const Scene scene = SCENE_WITH_TEXELS;
    const global Material *materials = SCENE_ARRAY(scene, Material, materials);
    const global uint *list = live + first;
    const Launch launch = {params, batch, surface, get_global_id(1)};
    const Chunk chunk = chunk_of(count);
    const bool is_weighted = LIGHTS && surface > 1u;
    FOR_EACH_ITEM_SERIALLY(i, launch.row == 0u ? count : 0u) {
        const uint k = list[i];
        met_light[i] = describe_met(scene, is_weighted, rays[k], pdfs[k], instance_at(instances, i), points[i], interfaces[i], directions[i],
                                    tints_at(tints, i));
    }
    PathColumns columns;
    meet_surfaces(scene, launch, count, pixels, list, paths, points, interfaces, directions, tints, &columns);
    const uint kinds = all_kinds(&columns.met.points);
    SampleColumns samples;
    sample_bsdfs(materials, kinds, &columns.met.points, &columns.random, &samples);
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const uint c = i - chunk.begin;
        const Path path = path_of_columns(&columns.paths, c);
        const MetSurface met = column_met(&columns.met, c);
        const BundleRow row = bundle_row(launch, path, met.material_flags);
        const BsdfSample sample = column_sample(&samples, c);
        const float roulette = roulette_of(launch, column_pixel_sample(&columns, c), row);
        next[launch.row * count + i] = describe_next(met, row, sample, next_path(met, path, row, sample, params.roulette_depth, roulette), roulette);
    }
    if (!LIGHTS) return;
    LightColumns lights;
    Vec3Columns towards;
    sample_lights(scene, launch, count, instances, &columns, &lights, &towards);
    ValueColumns values;
    evaluate_bsdfs(materials, kinds, &columns.met.points, &towards, &values);
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const uint c = i - chunk.begin;
        const Path path = path_of_columns(&columns.paths, c);
        const MetSurface met = column_met(&columns.met, c);
        const ChosenLight chosen = column_chosen(&columns, c);
        const LightSample sample = column_light(&lights, c);
        const BsdfValue value = column_value(&values, c);
        const AskingRay asking = asking_ray(met, path, bundle_row(launch, path, met.material_flags), chosen, sample, towards.z[c], value);
        asked[launch.row * count + i] = describe_asked(met, chosen, sample, towards.z[c], value, asking);
    }
}
