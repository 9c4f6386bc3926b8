/// Kinds of lights.
#pragma once
#include <vector>

#include "kernels/core/scene.h"
#include "kernels/lights/directional.h"
#include "kernels/lights/emission.h"
#include "kernels/lights/environment.h"
#include "kernels/lights/point.h"
#include "kernels/lights/spot.h"

namespace brandung {

class Parameters;

/// `kernels/lights/<name>.cl` has its device functions; Light.kind is its place in light_kinds().
struct LightKind {
    const char *name;    ///< in scene files and as prefix of device functions
    const char *record;  ///< its view of Light.words
    /// Power [W], about: by it paths choose lights. `extent` is how far the scene reaches from the origin, for what shines from or to infinitely far.
    Spectrum (*power)(const Light &light, float extent);
    bool is_far;                                  ///< shines from infinitely far
    Light (*read)(const Parameters &parameters);  ///< null: made of emissive shapes or the background
};
const std::vector<LightKind> &light_kinds();
/// Those that scene files name.
const std::vector<LightKind> &lights_of_files();
/// `intensity` [W/sr] is divided by attenuation.x + attenuation.y d + attenuation.z d² at the distance d, so these are not all zero.
Light make_light(const PointLight &light);
/// `direction`, of unit length, leads to where the light comes from; `irradiance` [W/m²] is that of a surface across it.
Light make_light(const DirectionalLight &light);
/// As a point light; `direction` has unit length, and shape_cone has set the cone.
Light make_light(const SpotLight &light);
Light make_light(const Environment &light);
/// Emissive shapes of radiance 1, in their own space.
Light make_light(const EmissiveMesh &light);
Light make_light(const EmissiveSphere &light);
Light make_light(const EmissiveFrustum &light);
Light make_light(const EmissiveDisk &light);
Light make_light(const EmissiveFlat &light);
/// rows * rows of them, each with its cell of the square from which points of the light are made, and its share of the light.
std::vector<Light> make_cells(const Light &light, uint rows);
/// Appends the cells, or flat faces, of an emissive shape, given this material's emission, in an instance or, for 0, in none; their random numbers
/// differ from those of all lights before.
void append_cells(const std::vector<Light> &cells, const Material &material, uint instance, std::vector<Light> &lights);
/// The cone has the full angle `angle` in (0, 2 pi] [radians]; over the outer part `penumbra` in [0, 1] of half of that the intensity falls to 0.
void shape_cone(SpotLight &light, double angle, double penumbra);

/// By what the intensity is divided at this distance, over its square.
float attenuation_to_square(vec3 attenuation, float distance);

/// The parts of a light's attenuation.
vec3 read_attenuation(const Parameters &parameters);

}  // namespace brandung
