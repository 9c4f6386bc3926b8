/// Lights that transparent objects enclose.
#pragma once
#include "scene/scene.h"

namespace brandung {

/// How many lights and emissive shapes lie inside the bounds of a transparent shape that does not shine itself.
uint count_enclosed_lights(const Scene &scene);

}  // namespace brandung
