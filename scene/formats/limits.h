/// The largest values of settings that options have, too.
#pragma once
#include "kernels/core/portable.h"

namespace brandung {

inline constexpr uint max_samples = 1u << 24;  ///< per pixel
inline constexpr uint max_depth = 1000;        ///< rays in a chain

}  // namespace brandung
