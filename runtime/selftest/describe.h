/// Inputs in words, exactly, so that they can be tried again.
#pragma once
#include <string>

#include "runtime/selftest/crossing_cases.h"

namespace brandung {

/// "(0x1p+0, 0x0p+0, 0x0p+0)".
std::string text_of(vec3 v);
/// "; round 0, input 17: ray ..., primitive ...", floats in hexadecimal.
std::string describe_case(const CrossingCases &cases, std::size_t i, uint round);

}  // namespace brandung
