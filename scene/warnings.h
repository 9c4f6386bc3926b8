/// Places of warnings.
#pragma once
#include <string>

#include "scene/scene.h"

namespace brandung {

/// Warnings that are new get the place that `place()` gives.
template <class Place> void place_warnings(Scene &scene, const Place &place) {
    if (scene.warning_places.size() == scene.warnings.size()) return;
    const std::string text = place();
    for (const auto &[warning, count] : scene.warnings) scene.warning_places.emplace(warning, text);
}

}  // namespace brandung
