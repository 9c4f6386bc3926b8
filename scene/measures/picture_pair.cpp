#include "scene/measures/picture_pair.h"

#include <fmt/core.h>

#include <algorithm>

#include "scene/error.h"
#include "scene/tone.h"
#include "scene/vectors.h"

namespace brandung {
namespace {

vec3 encoded(const vec3 &linear) {
    const vec3 inside = glm::clamp(linear, vec3(0), vec3(1));
    return vec3(srgb_encoded(inside.x), srgb_encoded(inside.y), srgb_encoded(inside.z));
}

}  // namespace

std::size_t PicturePair::not_finite() const { return std::size_t(std::count(finite.begin(), finite.end(), 0)); }

PicturePair pair_pictures(const Picture &test, const Picture &reference, DynamicRange range) {
    if (test.width != reference.width || test.height != reference.height)
        throw SceneError(fmt::format("pictures of {} x {} and {} x {} pixels cannot be compared: the sizes differ", test.width, test.height,
                                     reference.width, reference.height));
    PicturePair pair{.width = test.width, .height = test.height, .range = range};
    const auto value = [&](const vec3 &pixel) { return range == DynamicRange::hdr ? pixel : encoded(pixel); };
    for (std::size_t i = 0; i < test.pixels.size(); ++i) {
        const bool a = is_finite(test.pixels[i]), b = is_finite(reference.pixels[i]);
        pair.test_not_finite += !a, pair.reference_not_finite += !b;
        pair.finite.push_back(a && b);
        pair.test.push_back(a && b ? value(test.pixels[i]) : vec3(0));
        pair.reference.push_back(a && b ? value(reference.pixels[i]) : vec3(0));
    }
    if (pair.not_finite() == pair.finite.size()) throw SceneError("the pictures cannot be compared: they have no pixel that is finite in both");
    return pair;
}

vec3 linear_light(const vec3 &pixel, DynamicRange range) {
    if (range == DynamicRange::hdr) return glm::max(pixel, vec3(0));
    return vec3(srgb_decoded(pixel.x), srgb_decoded(pixel.y), srgb_decoded(pixel.z));
}

vec3 as_shown(const vec3 &pixel, DynamicRange range) { return range == DynamicRange::hdr ? encoded(pixel) : pixel; }

}  // namespace brandung
