/// The list of AOVs.
#include <limits>

#include "scene/aovs/aov.h"

namespace brandung {

const std::vector<AovKind> &aov_kinds() {
    static const std::vector<AovKind> kinds = {
        {"normal", AovKind::mean, false, {"N.X", "N.Y", "N.Z"}, 0},
        {"albedo", AovKind::mean, false, {"albedo.R", "albedo.G", "albedo.B"}, 0},
        {"depth", AovKind::mean, true, {"depth.Z"}, std::numeric_limits<float>::infinity()},
        {"position", AovKind::mean, true, {"P.X", "P.Y", "P.Z"}, 0},
        {"primitive", AovKind::number, false, {"primitive"}, 0},
        {"instance", AovKind::number, false, {"instance"}, 0},
        {"samples", AovKind::count, false, {"samples"}, 0},
    };
    return kinds;
}

}  // namespace brandung
