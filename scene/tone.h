/// From radiance to what a picture of integers stores, and back.
#pragma once
#include <vector>

#include "kernels/core/portable.h"

namespace brandung {

/// IEC 61966-2-1, of fractions of the brightest value: within 0.5001 ulp of a float, and the same bits everywhere. What is negative continues the
/// curve's straight part.
float srgb_encoded(float linear);
float srgb_decoded(float encoded);

/// How radiance, exposed, becomes the values of a picture of integers: monotone, 0 staying 0; both from 0 to 1, where input beyond is cut first
/// or, by a curve with a shoulder, bent.
struct ToneKind {
    const char *name;
    float (*curve)(float radiance);
    bool linear;  ///< the picture's values are so, and are no sRGB
};
const std::vector<ToneKind> &tone_kinds();

/// The exposure [EV, hundredths, -100 to 100] that makes the median luminance of all pixels that are not black middle grey, 0.18; 0 if all are black.
float automatic_exposure(const std::vector<vec3> &pixels);

}  // namespace brandung
