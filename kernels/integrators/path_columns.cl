// What a chunk of paths has met and chosen at its surfaces.
#pragma once
#include "generated/constants.h"
#include "generated/instances.cl"
#include "generated/tints.cl"
#include "kernels/core/columns.cl"
#include "kernels/core/load.cl"
#include "kernels/core/params.h"
#include "kernels/core/scene.cl"
#include "kernels/integrators/asking.cl"
#include "kernels/integrators/bundle.cl"
#include "kernels/integrators/met_surface.cl"
#include "kernels/lights/choice.cl"
#include "kernels/lights/light.cl"
#include "kernels/samplers/slot.cl"

// A path's uses of its sampler at each surface.
#define USE_DIRECTION 1u
#define USE_CHOICES 2u
#define USE_LIGHT 3u
#define USE_ROULETTE 4u
#define USES_PER_SURFACE 4u
// So far apart are the random numbers of a bundle's rows: odd, so that none come twice, and far beyond what is counted on from one.
#define APART 2654435769u

/// What a chunk's paths have met and chosen, a column for each word.
typedef struct {
    Columns paths;
    uint pixels[ITEMS_PER_WORK_ITEM], samples[ITEMS_PER_WORK_ITEM];  ///< as of PixelSample
    MetColumns met;
    RandomColumns random;                                                        ///< by which BSDFs choose
    uint lights[ITEMS_PER_WORK_ITEM];                                            ///< rows of the chosen ones
    float inverse_chances[ITEMS_PER_WORK_ITEM], radiances[ITEMS_PER_WORK_ITEM];  ///< as of ChosenLight
} PathColumns;

/// What is the same for all items of a row of a launch.
typedef struct {
    PathParams params;
    BatchParams batch;
    uint surface;  ///< its number on the paths, from 1 on
    uint row;      ///< of the bundles
} Launch;

FUNCTION BundleRow bundle_row(Launch launch, Path path, uint material_flags) {
    return bundle_row(path, launch.surface, launch.row, material_flags, launch.params.bundles);
}

/// A part's pair of numbers for a use at this surface.
FUNCTION vec2 pair_for(Launch launch, PixelSample which, Part part, uint use) {
    return sampler_pair(which.pixel, which.sample, part, (launch.surface - 1u) * USES_PER_SURFACE + use, launch.batch);
}

/// The number by which chance ends a part.
FUNCTION float roulette_of(Launch launch, PixelSample which, BundleRow row) {
    return pair_for(launch, which, part_within(row.path, row.going), USE_ROULETTE).x;
}

FUNCTION PixelSample column_pixel_sample(const PathColumns *columns, uint c) {
    PixelSample which;
    which.pixel = columns->pixels[c], which.sample = columns->samples[c];
    return which;
}

/// Fills the columns, all places of those that are computed with whether an item is there or not.
FUNCTION void meet_surfaces(Scene scene, Launch launch, uint count, const global uint *pixels, const global uint *list, const global Path *paths,
                            const global SurfacePoint *points, const global SurfaceInterface *interfaces, const global vec3 *directions,
                            const global Tints *tints, PathColumns *columns) {
    const global Material *materials = SCENE_ARRAY(scene, Material, materials);
    const Chunk chunk = chunk_of(count);
    uint numbers[ITEMS_PER_WORK_ITEM];
    list_numbers(list, chunk, numbers);
    fetch_columns(paths, 6u, numbers, chunk.items, &columns->paths);
    clear(&columns->met.points), clear(&columns->random);
    for (uint c = 0u; c < ITEMS_PER_WORK_ITEM; ++c) columns->lights[c] = 0u;
    FOR_EACH_ITEM(i, count) {
        const uint c = i - chunk.begin;
        const Path path = path_of_columns(&columns->paths, c);
        const PixelSample which = pixel_sample(path.slot, launch.batch, pixels);
        const SurfacePoint point = load(points + i);
        const MetSurface met = met_surface(materials, point, load(interfaces + i), load(directions + i));
        const BundleRow row = bundle_row(launch, path, met.material_flags);
        const vec2 direction = pair_for(launch, which, part_within(row.path, row.going), USE_DIRECTION);
        const vec2 choices = pair_for(launch, which, row.path, USE_CHOICES);
        columns->pixels[c] = which.pixel, columns->samples[c] = which.sample;
        store_met(&columns->met, c, materials, met, point.material, tints_at(tints, i));
        columns->random.x[c] = direction.x, columns->random.y[c] = direction.y;
        columns->random.choices[c] = place_of_part(row.going, choices.x);
        if (LIGHTS) {
            const ChosenLight light =
                light_chosen(scene, lit_origin(met), place_of_part(row.asking, choices.y), hash(path.branch + APART * launch.row));
            columns->lights[c] = light.row, columns->inverse_chances[c] = light.inverse_chance, columns->radiances[c] = light.radiance;
        }
    }
}

FUNCTION ChosenLight column_chosen(const PathColumns *columns, uint c) {
    ChosenLight chosen;
    chosen.row = columns->lights[c], chosen.inverse_chance = columns->inverse_chances[c], chosen.radiance = columns->radiances[c];
    return chosen;
}

/// Samples of the lights that the chunk has chosen, and their directions in the frames of the BSDFs.
FUNCTION void sample_lights(Scene scene, Launch launch, uint count, const global uint *instances, const PathColumns *columns, LightColumns *lights,
                            Vec3Columns *towards) {
    const Chunk chunk = chunk_of(count);
    Columns records;
    fetch_columns(SCENE_ARRAY(scene, Light, lights), 16u, columns->lights, chunk.items, &records);
    fill_columns(towards, make3(0.0f, 0.0f, 1.0f));
    FOR_EACH_ITEM(i, count) {
        const uint c = i - chunk.begin;
        const Path path = path_of_columns(&columns->paths, c);
        const MetSurface met = column_met(&columns->met, c);
        const BundleRow row = bundle_row(launch, path, met.material_flags);
        const vec2 square = pair_for(launch, column_pixel_sample(columns, c), part_within(row.path, row.asking), USE_LIGHT);
        LightRandom random = light_random(square, path.branch + APART * launch.row);
        SET_TIME(random, instance_at(instances, i).time);
        const LightSample sample = light_sample(scene, light_of_columns(&records, c), lit_origin(met), random);
        store_light(lights, c, sample);
        store_column(towards, c, to_frame(frame_of(met.axis), sample.direction));
    }
}
