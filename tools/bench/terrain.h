/// A terrain of any number of triangles: what rays are traced through where no file has so many.
#pragma once
#include "scene/scene.h"

namespace brandung {

/// About so many triangles, at least 5000, the same each time: half of them a warped height field, 100 units wide, the rest lumpy spheres and torus
/// knots, of as many triangles each as there are objects, which float above it and cover one another. One mesh; the camera looks across it from a
/// corner.
Scene terrain(uint triangles);

}  // namespace brandung
