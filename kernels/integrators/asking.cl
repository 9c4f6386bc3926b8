// Rays by which paths ask for light.
#pragma once
#include "kernels/core/columns.cl"
#include "kernels/core/spawn.cl"
#include "kernels/integrators/bundle.cl"
#include "kernels/integrators/met_surface.cl"
#include "kernels/integrators/power_heuristic.cl"
#include "kernels/lights/choice.cl"
#include "kernels/lights/light.cl"

/// Samples of a chunk's lights, a column for each member.
typedef struct {
    Vec3Columns directions, ray_directions, irradiances;
    float distances[ITEMS_PER_WORK_ITEM], inverse_densities[ITEMS_PER_WORK_ITEM];
} LightColumns;

FUNCTION void store_light(LightColumns *columns, uint c, LightSample sample) {
    store_column(&columns->directions, c, sample.direction), store_column(&columns->ray_directions, c, sample.ray_direction);
    store_column(&columns->irradiances, c, sample.irradiance);
    columns->distances[c] = sample.distance, columns->inverse_densities[c] = sample.inverse_density;
}

FUNCTION LightSample column_light(const LightColumns *columns, uint c) {
    LightSample sample;
    sample.direction = column_vec3(&columns->directions, c), sample.ray_direction = column_vec3(&columns->ray_directions, c);
    sample.irradiance = column_vec3(&columns->irradiances, c);
    sample.distance = columns->distances[c], sample.inverse_density = columns->inverse_densities[c];
    return sample;
}

/// Where lights see the surface from: on the side on which light falls.
FUNCTION vec3 lit_origin(MetSurface met) { return where((met.flags & SURFACE_LIT_BEYOND) != 0u, met.far, met.near); }

/// A ray that asks whether a light is visible.
typedef struct {
    Ray ray;
    float weight;    ///< against the chance that the BSDF finds the same
    Spectrum added;  ///< to the path's sample, if it is
    bool is_worth;
} AskingRay;

/// For this sample of the chosen light, of which the BSDF says `value`, weighted against the chance that the BSDF finds the same. `z`: of its
/// direction in the BSDF's frame.
FUNCTION AskingRay asking_ray(MetSurface met, Path path, BundleRow row, ChosenLight chosen, LightSample sample, float z, BsdfValue value) {
    AskingRay asking;
    asking.weight = power_heuristic(value.pdf * inverse_light_density(chosen, sample) * ratio_of_counts(row));
    const Spectrum received = scaled(times(value.value, sample.irradiance), chosen.inverse_chance * (asking.weight * share_of(row.asking)));
    asking.ray = ray_to_light(where(z > 0.0f, met.near, met.far), sample.ray_direction, sample.distance, source_of(met, sample.direction, z));
    asking.added = times(path.throughput, received);
    asking.is_worth =
        is_there(met) && may_come_from(met, sample.direction, z) && largest(asking.added) > 0.0f && row.asking.number < row.asking.count;
    return asking;
}
