/// A colour map for differences.
#pragma once
#include "kernels/core/portable.h"

namespace brandung {

/// From black at 0 through violet and orange to a light yellow at 1, ever lighter; linear Rec. 709. Values beyond are clamped.
vec3 heat_colour(float value);

}  // namespace brandung
