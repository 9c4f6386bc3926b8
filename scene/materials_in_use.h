/// Which materials something of a scene has.
#pragma once
#include <vector>

#include "scene/scene.h"

namespace brandung {

/// By material: whether something that is seen has it, in the world or in an instance, be it by one that chooses
/// among others.
std::vector<bool> materials_in_use(const Scene &scene);

}  // namespace brandung
