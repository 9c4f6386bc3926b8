/// Rays that no camera sends: such as find what accelerators lose.
#pragma once
#include "runtime/accelerators/ray_sample.h"
#include "scene/scene.h"

namespace brandung {

/// So many rays in and around the scene's box, the same each time: a quarter from far outside towards it, an eighth along axes, an eighth in planes
/// of objects' boxes, an eighth through corners of these, the rest from anywhere to anywhere; a quarter of all ends somewhere in the box. Once as
/// rays that ask for the closest hit and once as shadow rays. Nothing of a scene without objects.
std::vector<RayQueue> random_rays(const Scene &scene, std::size_t count);

}  // namespace brandung
