/// Measured indices of refraction.
#pragma once
#include <vector>

#include "kernels/core/portable.h"

namespace brandung {

/// Of index eta + i k.
struct Metal {
    const char *name;
    Spectrum eta, k;
};
const std::vector<Metal> &metals();

}  // namespace brandung
