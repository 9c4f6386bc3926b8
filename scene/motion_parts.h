/// Motions as devices have them: in parts, of which polynomials of time say where things are.
#pragma once
#include <optional>
#include <vector>

#include "kernels/primitives/motion.h"
#include "scene/motion.h"

namespace brandung {

/// The motion while the shutter is open for some time, in so many parts that polynomials move what lies in the bounds by no more than a millionth of
/// its largest coordinate from where it should be. Nothing if that takes too many.
std::optional<std::vector<MotionPart>> motion_parts(const Motion &motion, const Shutter &shutter, const Bounds &bounds);

/// A box around all that rays can meet of a group with these bounds at any time of these parts, as of bounds_in_world of a group at rest.
Bounds bounds_in_world(const std::vector<MotionPart> &parts, const Bounds &bounds);

}  // namespace brandung
