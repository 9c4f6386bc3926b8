/// Which light a path asks: each as likely as its power is of all, but those that are infinitely far, whose power grows with the scene, not more
/// often together than all others.
#pragma once
#include <vector>

#include "kernels/lights/light_choice.h"
#include "scene/lights/light_rows.h"

namespace brandung {

struct LightChoices {
    std::vector<LightChoice> choices;  ///< by row
    float emission = 0;                ///< SceneHeader.emission_chance
    float environment = 0;             ///< SceneHeader.environment_density
};

/// Empty if no light has any power. `extent`: see LightKind::power.
LightChoices make_light_choices(const LightRows &lights, const Scene &scene, float extent);

}  // namespace brandung
