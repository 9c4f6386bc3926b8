/// Scenes for pictures whose values are known: an eye, floors and boxes.
#pragma once
#include "tests/support/scenes.h"

namespace brandung {

/// Seen under `degrees`, in a square picture of so many pixels.
Scene scene_seen_from(vec3 from, vec3 at, float degrees, uint size = 40);

void add_quad(Scene &scene, uint material, vec3 a, vec3 b, vec3 c, vec3 d);
/// A square of side 2 * half in the plane y = height, its outside above.
void add_floor(Scene &scene, uint material, float half, float height);
/// The sides of a box, outsides outside, or inside with `inwards`.
void add_box(Scene &scene, uint material, vec3 low, vec3 high, bool inwards = false);

}  // namespace brandung
