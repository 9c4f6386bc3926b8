/// What lights a scene: its lights, and its shapes that shine.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "scene/placed_shapes.h"

namespace brandung {

/// Every surface point sends one shadow ray to each row: to a light, or to one stratum of an emissive shape.
struct LightRows {
    std::vector<Light> rows;
    std::vector<PlacedShape> shapes;     ///< by row: what a stratum is of; no shape for the scene's lights, which come first
    std::vector<EmissiveFace> faces;     ///< of emissive meshes, in their own spaces
    uint dark = 0;                       ///< emissive shapes of which the integrator takes no samples
    std::map<std::string, uint> counts;  ///< of lights and emissive shapes, by kind; shapes of a group count in each of its instances
};

/// Emissive shapes are lights if the integrator takes samples of them and there is a surface on which light can be seen.
LightRows make_light_rows(const Scene &scene);

}  // namespace brandung
