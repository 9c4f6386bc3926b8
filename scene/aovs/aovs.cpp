/// The list of AOVs.
#include <limits>

#include "scene/aovs/aov.h"

namespace brandung {

const std::vector<AovKind> &aov_kinds() {
    static const std::vector<AovKind> kinds = {
        {"normal", AovKind::filtered, {"N.X", "N.Y", "N.Z"}, 0},
        {"albedo", AovKind::filtered, {"albedo.R", "albedo.G", "albedo.B"}, 0},
        {"depth", AovKind::length, {"depth.Z"}, std::numeric_limits<float>::infinity()},
        {"position", AovKind::length, {"P.X", "P.Y", "P.Z"}, 0},
        {"primitive", AovKind::number, {"primitive"}, 0},
        {"instance", AovKind::number, {"instance"}, 0},
        {"samples", AovKind::count, {"samples"}, 0},
        {"error", AovKind::error, {"error.R", "error.G", "error.B"}, 0},
    };
    return kinds;
}

}  // namespace brandung
