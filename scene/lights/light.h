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
/// `intensity` [W/sr] is divided by attenuation.x + attenuation.y d + attenuation.z d² at the distance d, so these are not all zero.
Light make_light(const PointLight &light);
/// `direction`, of unit length, leads to where the light comes from; `irradiance` [W/m²] is that of a surface across it.
Light make_light(const DirectionalLight &light);

}  // namespace brandung
