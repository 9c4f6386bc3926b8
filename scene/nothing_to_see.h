/// What makes a picture that shows nothing, and is rarely meant.
#pragma once
#include "scene/scene.h"

namespace brandung {

/// Warns of a scene without objects, and of one whose objects are all black.
void warn_of_nothing_to_see(Scene &scene);

}  // namespace brandung
