/// Two pictures as they are compared.
#pragma once
#include <cstdint>

#include "scene/image.h"

namespace brandung {

/// What the values of a compared picture mean.
enum class DynamicRange {
    ldr,  ///< sRGB-encoded, from 0 to 1
    hdr,  ///< linear radiance
};

/// A picture under test and its reference, row by row from the top. Where a pixel of either has a channel that is NaN or infinite, both are black,
/// and the pixel is left out of every sum.
struct PicturePair {
    uint width = 0, height = 0;
    DynamicRange range = DynamicRange::ldr;
    std::vector<vec3> test, reference;
    std::vector<std::uint8_t> finite;                           ///< whether both are, per pixel
    std::size_t test_not_finite = 0, reference_not_finite = 0;  ///< so many pixels of each

    std::size_t not_finite() const;  ///< pixels left out
};

/// For LDR the linear values are clamped to [0, 1] and encoded. Throws SceneError if the sizes differ, if there are no pixels or if none is left.
PicturePair pair_pictures(const Picture &test, const Picture &reference, DynamicRange range);

/// Linear radiance of a compared pixel, at least 0.
vec3 linear_light(const vec3 &pixel, DynamicRange range);
/// The pixel as it is shown: sRGB-encoded, from 0 to 1.
vec3 as_shown(const vec3 &pixel, DynamicRange range);

}  // namespace brandung
