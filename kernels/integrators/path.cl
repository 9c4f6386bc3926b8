// Path tracing (Kajiya, SIGGRAPH 1986) with light asked at every surface, both ways of finding it weighted by Veach's power heuristic (thesis 1997,
// section 9.2); from the surface that the eye sees on in bundles, where there are some. The loop over these kernels is runtime/integrators/path.cpp.
#include "generated/constants.h"
#include "generated/instances.cl"
#include "generated/interior.cl"
#include "generated/tints.cl"
#include "kernels/core/load.cl"
#include "kernels/core/scene.cl"
#include "kernels/integrators/asking.cl"
#include "kernels/integrators/bundle.cl"
#include "kernels/integrators/met_light.cl"
#include "kernels/integrators/next_path.cl"
#include "kernels/integrators/path_columns.cl"

/// Whether in this row no item of the chunk sends any ray.
FUNCTION bool is_silent(const global Material *materials, const global SurfacePoint *points, Chunk chunk, Launch launch) {
    bool any = false;
    for (uint c = 0u; c < chunk.items; ++c) any |= (points[chunk.begin + c].flags & SURFACE_HIT) != 0u;
    if (!BUNDLES) return !any;
    return !any || is_beyond_bundles(materials, points, chunk, launch.row, launch.params.bundles);
}

/// From live item i, in row j of its bundle: the ray that goes on, in slot base + j * count + i, in the medium that it is in then, with the density
/// `child_pdfs` of its direction; and shadow ray j * stride + i, with what the light that it asks adds to the sample where it is visible. No ray
/// leaves for a black value, nor in rows beyond the bundle. `surface` is the number of the surfaces on their paths, from 1 on.
kernel void spawn_path(SCENE_PARAMS, PathParams params, uint surface, BatchParams batch, const global uint *restrict pixels, LIVE_PARAMS,
                       const global Path *restrict paths, const global SurfacePoint *restrict points,
                       const global SurfaceInterface *restrict interfaces, const global vec3 *restrict directions,
                       const global uint *restrict instances, const global Tints *restrict tints, const global uint *restrict interiors,
                       const global uint *restrict beyond, const global Texel *restrict scene_texels, uint base, uint stride,
                       global Ray *restrict children, global Path *restrict child_paths, global float *restrict child_pdfs,
                       global uint *restrict child_sources, global uint *restrict child_interiors, global uchar *restrict child_alive,
                       global Ray *restrict shadow_rays, global Spectrum *restrict shadow_light, global uchar *restrict shadow_alive) {
    const Scene scene = SCENE_WITH_TEXELS;
    const global Material *materials = SCENE_ARRAY(scene, Material, materials);
    const global uint *list = live + first;
    const Launch launch = {params, batch, surface, BUNDLES ? get_global_id(1) : 0u};
    const uint first_slot = base + launch.row * count, first_shadow = launch.row * stride;
    global uchar *first_alive = child_alive + launch.row * count;
    const Chunk chunk = chunk_of(count);
    if (is_silent(materials, points, chunk, launch)) {
        for (uint i = chunk.begin; i < chunk.begin + chunk.items; ++i) first_alive[i] = 0;
        for (uint i = chunk.begin; LIGHTS && i < chunk.begin + chunk.items; ++i) shadow_alive[first_shadow + i] = 0;
        return;
    }
    PathColumns columns;
    meet_surfaces(scene, launch, count, pixels, list, paths, points, interfaces, directions, tints, &columns);
    const uint kinds = all_kinds(&columns.met.points);
    SampleColumns samples;
    sample_bsdfs(materials, kinds, &columns.met.points, &columns.random, &samples);
    {
        FOR_EACH_ITEM(i, count) {
            const uint k = list[i], c = i - chunk.begin;
            const Path path = path_of_columns(&columns.paths, c);
            const MetSurface met = column_met(&columns.met, c);
            const BundleRow row = bundle_row(launch, path, met.material_flags);
            const float roulette = roulette_of(launch, column_pixel_sample(&columns, c), row);
            const NextPath child = next_path(met, path, row, column_sample(&samples, c), params.roulette_depth, roulette);
            interior_choose(!child.enters, interiors, k, beyond, i, child_interiors, first_slot + i);
            store_instance(child_sources, first_slot + i, instance_at(instances, i));
            children[first_slot + i] = child.ray;
            child_paths[first_slot + i] = child.path;
            child_pdfs[first_slot + i] = child.pdf;
            first_alive[i] = child.lives;
        }
    }
    if (!LIGHTS) return;
    LightColumns lights;
    Vec3Columns towards;
    sample_lights(scene, launch, count, instances, &columns, &lights, &towards);
    ValueColumns values;
    evaluate_bsdfs(materials, kinds, &columns.met.points, &towards, &values);
    FOR_EACH_ITEM(i, count) {
        const uint c = i - chunk.begin;
        const Path path = path_of_columns(&columns.paths, c);
        const MetSurface met = column_met(&columns.met, c);
        const AskingRay asking = asking_ray(met, path, bundle_row(launch, path, met.material_flags), column_chosen(&columns, c),
                                            column_light(&lights, c), towards.z[c], column_value(&values, c));
        shadow_rays[first_shadow + i] = asking.ray;
        shadow_light[first_shadow + i] = asking.added;
        shadow_alive[first_shadow + i] = asking.is_worth;
    }
}

/// Adds what the chunk's rays bring that have met nothing, if there are any.
FUNCTION void add_background(Scene scene, bool is_weighted, const global uint *list, uint count, const global Path *paths, const global float *pdfs,
                             const global SurfacePoint *points, const global vec3 *directions, const global Tints *tints,
                             global Spectrum *contributions) {
    const Chunk chunk = chunk_of(count);
    uchar is_miss[ITEMS_PER_WORK_ITEM];
    uchar any = 0;
    for (uint c = 0u; c < chunk.items; ++c) any |= is_miss[c] = (points[chunk.begin + c].flags & SURFACE_HIT) == 0u;
    if (any == 0 || largest(scene.header->background) == 0.0f) return;
    FOR_EACH_ITEM(i, count) {
        const uint k = list[i];
        const Spectrum met = met_background(scene, is_weighted, pdfs[k], load(directions + i), tints_at(tints, i));
        const Spectrum before = load(contributions + i), all = plus(times(met, load(&paths[k].throughput)), before);
        contributions[i] = where(is_miss[i - chunk.begin] != 0, all, before);
    }
}

/// contributions[i]: what ray i adds to its sample by the light that the surface where it ends asks, in `rows` rows of so many entries, as far as
/// `visible` says; and by the background, and, of few rays, by what shines there.
kernel void shade_path(SCENE_PARAMS, uint first_generation, LIVE_PARAMS, const global Ray *restrict rays, const global Path *restrict paths,
                       const global float *restrict pdfs, const global uint *restrict instances, const global SurfacePoint *restrict points,
                       const global SurfaceInterface *restrict interfaces, const global vec3 *restrict directions, const global Tints *restrict tints,
                       uint rows, uint stride, const global uchar *restrict visible, const global Spectrum *restrict shadow_light,
                       global Spectrum *restrict contributions) {
    const Scene scene = SCENE;
    const global Material *materials = SCENE_ARRAY(scene, Material, materials);
    const bool is_weighted = LIGHTS && first_generation == 0u;
    add_asked_light(count, rows, stride, visible, shadow_light, contributions);
    add_background(scene, is_weighted, live + first, count, paths, pdfs, points, directions, tints, contributions);
    FOR_EACH_ITEM_SERIALLY(i, count) {
        if ((points[i].flags & SURFACE_HIT) == 0u || (materials[points[i].material].flags & MATERIAL_SHINES) == 0u) continue;
        const uint k = live[first + i];
        const Spectrum met = met_light(scene, is_weighted, rays[k], pdfs[k], instance_at(instances, i), points[i], interfaces[i], directions[i]);
        contributions[i] = plus(times(met, paths[k].throughput), contributions[i]);
    }
}
