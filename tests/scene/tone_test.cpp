#include "scene/tone.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

namespace brandung {
namespace {

float (*curve(const std::string &name))(float) {
    for (const ToneKind &kind : tone_kinds())
        if (kind.name == name) return kind.curve;
    throw std::runtime_error(name);
}

TEST(Tone, CurvesAreMonotoneFrom0To1AndBlackStaysBlack) {
    for (const ToneKind &kind : tone_kinds()) {
        EXPECT_EQ(kind.curve(0), 0) << kind.name;
        EXPECT_EQ(kind.curve(-1), 0) << kind.name;
        EXPECT_NEAR(kind.curve(std::numeric_limits<float>::max()), 1, 1e-6f) << kind.name;
        float before = 0;
        // Neighbours are so far apart that the rounding of some ulp is less than what the curves rise, except where they are cut.
        for (float x = 1e-6f; x < 100; x *= 1.001f) {
            const float y = kind.curve(x);
            EXPECT_GE(y, before) << kind.name << ", " << x;
            EXPECT_LE(y, 1 + 1e-6f) << kind.name << ", " << x;
            before = y;
        }
    }
}

/// srgb: 0.5 and 0.18 from tables of IEC 61966-2-1. filmic: at 0.18 the fraction is 0.18 * 0.4818 / (0.18 * 1.0274 + 0.14) = 0.26691, at 1 it is
/// 2.54 / 3.16 = 0.80380; then sRGB.
TEST(Tone, CurvesGoThroughKnownPoints) {
    EXPECT_NEAR(curve("srgb")(0.18f), 0.46136f, 1e-5f);
    EXPECT_NEAR(curve("srgb")(0.5f), 0.73536f, 1e-5f);
    EXPECT_EQ(curve("none")(0.5f), 0.5f);
    EXPECT_EQ(curve("none")(2), 1);
    const auto encoded = [](double x) { return float(1.055 * std::pow(x, 1 / 2.4) - 0.055); };
    EXPECT_NEAR(curve("filmic")(0.18f), encoded(0.26691), 2e-5f);
    EXPECT_NEAR(curve("filmic")(1), encoded(0.80380), 1e-5f);
    EXPECT_LT(curve("filmic")(4), 1);
    EXPECT_NEAR(curve("filmic")(7.25f), 1, 1e-4f);
}

TEST(Tone, SrgbIsDecodedToWhatWasEncoded) {
    for (float x = 0; x <= 1; x += 0.001f) EXPECT_NEAR(srgb_decoded(srgb_encoded(x)), x, 1e-6f);
}

/// Of a positive number.
double ulp(long double x) { return std::exp2(std::ilogb(x) - 23); }

/// Both curves are within their bound of those in extended precision: at all values of 16 bits, and at floats up to 2^50, most 1 / 1009 of an
/// octave apart. Neither powf nor a formula in floats is.
TEST(Tone, SrgbIsRoundedOnce) {
    const auto decoded = [](long double x) { return x <= 0.04045f ? x / 12.92L : std::pow((x + 0.055L) / 1.055L, 2.4L); };
    const auto encoded = [](long double x) { return x <= 0.0031308f ? x * 12.92L : 1.055L * std::pow(x, 1 / 2.4L) - 0.055L; };
    std::vector<float> values;
    for (int i = 1; i <= 65535; ++i) values.push_back(float(i / 65535.0));
    for (int i = -20000; i < 15000; ++i) values.push_back(float(std::exp2(i / 1009.0)));
    for (int i = 0; i < 1000; ++i) values.push_back(std::exp2(float(i) * 0.05f));
    for (const float x : values) {
        EXPECT_LE(std::abs(srgb_decoded(x) - decoded(x)), 0.5001 * ulp(decoded(x))) << x;
        EXPECT_LE(std::abs(srgb_encoded(x) - encoded(x)), 0.5001 * ulp(encoded(x))) << x;
    }
    EXPECT_EQ(srgb_decoded(0), 0);
    EXPECT_EQ(srgb_decoded(1), 1);
    EXPECT_EQ(srgb_encoded(1), 1);
}

/// Median luminance 0.045 is two stops below 0.18; black pixels and a few very bright ones do not count.
TEST(Tone, AutomaticExposureMakesTheMedianMiddleGrey) {
    std::vector<vec3> pixels(1000, vec3(0));
    EXPECT_EQ(automatic_exposure(pixels), 0);
    for (int i = 0; i < 5; ++i) pixels.push_back(vec3(0.045f)), pixels.push_back(vec3(0.01f)), pixels.push_back(vec3(1e4f));
    EXPECT_EQ(automatic_exposure(pixels), 2);
    // Green alone has luminance 0.7152: log2(0.18 / 0.7152) = -1.990.
    EXPECT_EQ(automatic_exposure({vec3(0, 1, 0)}), -1.99f);
    EXPECT_EQ(automatic_exposure({vec3(1e-38f)}), 100);
}

}  // namespace
}  // namespace brandung
