/// Shapes where they are seen: in the world, and in every instance of their group.
#pragma once
#include <vector>

#include "scene/scene.h"

namespace brandung {

struct PlacedShape {
    const Shape *shape = nullptr;
    uint instance = 0;            ///< its number on the device, one more than in Scene::instances; 0: in none
    uint material = NO_MATERIAL;  ///< that of the instance, if it has one, else the shape's own
};

/// Those that shine, in scene order, the world's first.
std::vector<PlacedShape> emissive_shapes(const Scene &scene);

}  // namespace brandung
