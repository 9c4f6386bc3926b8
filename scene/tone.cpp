#include "scene/tone.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace brandung {
namespace {

constexpr float middle_grey = 0.18f;

/// Rec. 709.
float luminance(const vec3 &pixel) { return 0.2126f * pixel.x + 0.7152f * pixel.y + 0.0722f * pixel.z; }

/// The nth root of a positive number, by + - * / alone, so that libraries have no say in the bits of a picture; n is 3 or 5. The first guess, a
/// straight line through exponents, is within 6.2 %; steps of Newton's take its relative error e to (n - 1) / 2 e^2, to the rounding of doubles.
template <int n> double root(double x) {
    constexpr std::uint64_t bits_of_one = std::bit_cast<std::uint64_t>(1.0);
    double y = std::bit_cast<double>(bits_of_one - bits_of_one / n + std::bit_cast<std::uint64_t>(x) / n);
    for (int step = 0; step < 5; ++step) {
        double power = 1;
        for (int i = 1; i < n; ++i) power *= y;
        y += (x / power - y) * (1.0 / n);
    }
    return y;
}

float cut(float radiance) { return std::clamp(radiance, 0.0f, 1.0f); }

float srgb(float radiance) { return srgb_encoded(cut(radiance)); }

/// Narkowicz, "ACES filmic tone mapping curve" (2015): x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14), which is 1 at 7.25; then the sRGB curve.
float filmic(float radiance) {
    const float x = std::clamp(radiance, 0.0f, 8.0f);
    return srgb(x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f));
}

}  // namespace

float srgb_encoded(float linear) {
    if (!(linear > 0.0031308f && linear < std::numeric_limits<float>::infinity())) return float(12.92 * linear);
    const double root_of_2 = std::sqrt(double(linear)), root_of_4 = std::sqrt(root_of_2);
    return float(1.055 * root_of_4 * root<3>(root_of_2) - 0.055);  // 5 / 12 = 1 / 4 + 1 / 6
}

float srgb_decoded(float encoded) {
    if (!(encoded > 0.04045f && encoded < std::numeric_limits<float>::infinity())) return float(encoded / 12.92);
    const double x = (encoded + 0.055) / 1.055;
    return float(x * x * root<5>(x * x));  // 12 / 5 = 2 + 2 / 5
}

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
