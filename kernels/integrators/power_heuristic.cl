// How what can be found in two ways is weighted (Veach, thesis 1997, section 9.2).
#pragma once
#include "kernels/core/portable.h"

/// The weight of what was found with the density a, where the other way would have found it with the density b, given b / a.
FUNCTION float power_heuristic(float ratio) { return 1.0f / fma(ratio, ratio, 1.0f); }
