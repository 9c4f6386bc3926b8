/// Places of warnings.
#pragma once
#include <string>

namespace brandung {

/// Warnings that are new get the place that `place()` gives. `warned` is a scene, or what it was compiled to.
template <class Warned, class Place> void place_warnings(Warned &warned, const Place &place) {
    if (warned.warning_places.size() == warned.warnings.size()) return;
    const std::string text = place();
    for (const auto &[warning, count] : warned.warnings) warned.warning_places.emplace(warning, text);
}

}  // namespace brandung
