/// The curve of sRGB.
#pragma once
#include <cmath>

#include "kernels/core/portable.h"

namespace brandung {

/// IEC 61966-2-1, from encoded to linear; `encoded` is from 0 to 1, and what is not is taken as the nearest that is.
inline float srgb_to_linear(float encoded) {
    const float e = std::fmin(std::fmax(encoded, 0.0f), 1.0f);
    return e <= 0.04045f ? e / 12.92f : std::pow((e + 0.055f) / 1.055f, 2.4f);
}
inline Spectrum srgb_to_linear(vec3 encoded) { return {srgb_to_linear(encoded.x), srgb_to_linear(encoded.y), srgb_to_linear(encoded.z)}; }

}  // namespace brandung
