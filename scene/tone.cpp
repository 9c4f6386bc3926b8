#include "scene/tone.h"

#include <algorithm>
#include <cmath>

namespace brandung {
namespace {

constexpr float middle_grey = 0.18f;

/// Rec. 709.
float luminance(const vec3 &pixel) { return 0.2126f * pixel.x + 0.7152f * pixel.y + 0.0722f * pixel.z; }

float cut(float radiance) { return std::clamp(radiance, 0.0f, 1.0f); }

float srgb(float radiance) { return srgb_encoded(cut(radiance)); }

/// Narkowicz, "ACES filmic tone mapping curve" (2015): x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14), which is 1 at 7.25; then the sRGB curve.
float filmic(float radiance) {
    const float x = std::clamp(radiance, 0.0f, 8.0f);
    return srgb(x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f));
}

}  // namespace

float srgb_encoded(float linear) { return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f; }

float srgb_decoded(float encoded) { return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f); }

const std::vector<ToneKind> &tone_kinds() {
    static const std::vector<ToneKind> kinds = {{"srgb", srgb, false}, {"filmic", filmic, false}, {"none", cut, true}};
    return kinds;
}

float automatic_exposure(const std::vector<vec3> &pixels) {
    std::vector<float> bright;
    for (const vec3 &pixel : pixels)
        if (const float l = luminance(pixel); l > 0) bright.push_back(l);
    if (bright.empty()) return 0;
    const auto median = bright.begin() + static_cast<std::ptrdiff_t>(bright.size() / 2);
    std::nth_element(bright.begin(), median, bright.end());
    return std::clamp(std::round(100 * std::log2(middle_grey / *median)) / 100, -100.0f, 100.0f);
}

}  // namespace brandung
