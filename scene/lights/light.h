/// Kinds of lights.
#pragma once
#include <vector>

#include "kernels/core/scene.h"
#include "kernels/lights/directional.h"
#include "kernels/lights/point.h"

namespace brandung {

class Parameters;

/// `kernels/lights/<name>.cl` has its device functions; Light.kind is its place in light_kinds().
struct LightKind {
    const char *name;    ///< in scene files and as prefix of device functions
    const char *record;  ///< its view of Light.words
    Light (*read)(const Parameters &parameters);
};
const std::vector<LightKind> &light_kinds();
Light make_light(const PointLight &light);
Light make_light(const DirectionalLight &light);

}  // namespace brandung
