/// What lights a scene: its lights, and its shapes that shine.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "scene/lights/environment.h"
#include "scene/placed_shapes.h"

namespace brandung {

/// Every surface point sends one shadow ray to each row: to a light, or to one stratum of an emissive shape.
struct LightRows {
    std::vector<Light> rows;
    std::vector<PlacedShape> shapes;     ///< by row: what a stratum is of; no shape for the scene's lights, which come first, and the background
    std::vector<EmissiveFace> faces;     ///< of emissive meshes, in their own spaces
    EnvironmentTable environment;        ///< of the background, whose row is the last one; empty if it is no light
    uint dark = 0;                       ///< emissive shapes of which the integrator takes no samples
    std::map<std::string, uint> counts;  ///< of lights and emissive shapes, by kind; shapes of a group count in each of its instances
};

/// Emissive shapes, and for paths a picture as background, are lights if the integrator takes samples of them and there is a surface on which light
/// can be seen.
LightRows make_light_rows(const Scene &scene);

}  // namespace brandung
