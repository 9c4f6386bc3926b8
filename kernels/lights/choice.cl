// The light that a path asks at a surface, and how likely it would have asked for what a ray meets.
#pragma once
#include "generated/constants.h"
#include "generated/emissive_instances.cl"
#include "generated/environment.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/random.cl"
#include "kernels/core/scene.cl"
#include "kernels/lights/light.h"
#include "kernels/lights/light_choice.h"
#include "kernels/primitives/primitive.cl"

/// Never stored.
typedef struct {
    uint row;              ///< of the scene's lights
    float inverse_chance;  ///< over the probability of this light
    float radiance;        ///< as of LightChoice
} ChosenLight;

/// For a surface at p, though today lights are chosen by their power, wherever it is: what chooses by p gives emission_density, which is told the
/// same point as `from`, its own chance too. By u in [0, 1), of 24 bits, below which a hash of `random` decides: however many lights there are, each
/// interval of u that means a light has 2^24 steps.
FUNCTION ChosenLight light_chosen(Scene scene, vec3 p, float u, uint random) {
    const global LightChoice *choices = SCENE_ARRAY(scene, LightChoice, light_choices);
    const uint count = scene.header->light_choices.count;
    const uint64 steps = (uint64)((uint)(int)(u * 0x1p24f) << 8) * count + ((uint64)hash(random + 8u) * count >> 24);
    const uint entry = (uint)(steps >> 32);
    const float place = unit_interval((uint)steps);
    const uint row = place < choices[entry].kept ? entry : choices[entry].alias;
    ChosenLight chosen;
    chosen.row = row, chosen.inverse_chance = choices[row].inverse_chance, chosen.radiance = choices[row].radiance;
    return chosen;
}

FUNCTION float mean_of(Spectrum s) { return (s.x + s.y + s.z) * (1.0f / 3.0f); }

/// Over the density with which a path chooses the direction of this sample of the light [sr]; 0 for a light that shines from one point or direction.
FUNCTION float inverse_light_density(ChosenLight chosen, LightSample sample) {
    return (sample.inverse_density + mean_of(sample.irradiance) / chosen.radiance) * chosen.inverse_chance;
}

/// The density with which a path at `from` would have chosen, as a point of a light, what its ray met at p, `distance` away [1/sr]: with the unit
/// normal there, on a primitive of this radiance, in that place. 0 where emissive shapes are not asked.
FUNCTION float emission_density(Scene scene, ShadingRecord record, Placement place, Spectrum radiance, vec3 from, vec3 p, vec3 normal, float distance,
                                float cosine) {
    const bool flat = (FLAT_KINDS >> record.kind & 1u) != 0u;
    const float by_area = mean_of(radiance) * scene.header->emission_chance * emissive_area_in_power(scene, place, normal, flat);
    const vec3 from_in_group = lit_point_in_group(scene, place, from), p_in_group = lit_point_in_group(scene, place, p);
    return by_area * primitive_emission_factor(record, from_in_group, p_in_group) * distance * distance / fabs(cosine);
}
