#include "scene/measures/pixel_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/scene/measures/pictures.h"

namespace brandung {
namespace {

/// One pixel, a = (0.5, 1, 0) and b = (0.25, 1, 1).
TEST(PixelErrors, OfOnePixelAreThoseOfTheirDefinitions) {
    const PixelErrors errors = pixel_errors(hdr_pair(1, 1, constant({0.5f, 1, 0}), constant({0.25f, 1, 1})));
    EXPECT_DOUBLE_EQ(errors.mse, (0.0625 + 0 + 1) / 3);
    EXPECT_DOUBLE_EQ(errors.relmse, (0.0625 / (0.0625 + 0.01) + 0 + 1 / 1.01) / 3);
    EXPECT_DOUBLE_EQ(errors.mape, (0.25 / (0.25 + 0.01) + 0 + 1 / 1.01) / 3);
    EXPECT_DOUBLE_EQ(errors.peak, 1);
    EXPECT_DOUBLE_EQ(errors.psnr, -10 * std::log10(1.0625 / 3));
    EXPECT_EQ(errors.test_mean, glm::dvec3(0.5, 1, 0));
    EXPECT_EQ(errors.reference_mean, glm::dvec3(0.25, 1, 1));
}

TEST(PixelErrors, OfEqualPicturesAreZeroAndPsnrIsInfinite) {
    const PixelErrors errors = pixel_errors(ldr_pair(20, 20, ramp, ramp));
    EXPECT_EQ(errors.mse, 0);
    EXPECT_EQ(errors.relmse, 0);
    EXPECT_EQ(errors.mape, 0);
    EXPECT_EQ(errors.max_error.error, 0);
    EXPECT_EQ(errors.worst_block.relmse, 0);
    EXPECT_EQ(errors.psnr, std::numeric_limits<double>::infinity());
}

/// LDR pictures are compared as they are stored: a difference of 51 of 255 is 0.2, wherever on the curve.
TEST(PixelErrors, OfLdrPicturesAreOfEncodedValues) {
    const PixelErrors errors = pixel_errors(ldr_pair(4, 4, constant({51, 102, 204}), constant({0, 51, 255})));
    EXPECT_NEAR(errors.mse, 0.04, 1e-7);
    EXPECT_NEAR(errors.psnr, 10 * std::log10(25), 1e-5);
    EXPECT_NEAR(errors.reference_mean.y, 0.2, 1e-7);
}

/// The peak is the greatest value of both: 8, and mse 1, give 10 log10(64).
TEST(PixelErrors, PsnrOfHdrPicturesIsRelativeToTheGreatestValue) {
    const PixelErrors errors = pixel_errors(hdr_pair(8, 2, constant(vec3(7)), constant(vec3(8))));
    EXPECT_EQ(errors.peak, 8);
    EXPECT_DOUBLE_EQ(errors.psnr, 10 * std::log10(64));
}

/// 40 x 20 pixels, one of them 3 instead of 1 in green: it lies in the third block of the second row, which is 8 x 4 pixels.
TEST(PixelErrors, TheWorstBlockAndTheGreatestErrorHaveTheirPlaces) {
    const auto spoiled = [](int x, int y, int c) { return x == 37 && y == 18 && c == 1 ? 3.0f : 1.0f; };
    const PixelErrors errors = pixel_errors(hdr_pair(40, 20, spoiled, constant(vec3(1))));
    EXPECT_EQ(errors.worst_block.x, 32u);
    EXPECT_EQ(errors.worst_block.y, 16u);
    EXPECT_EQ(errors.worst_block.width, 8u);
    EXPECT_EQ(errors.worst_block.height, 4u);
    EXPECT_DOUBLE_EQ(errors.worst_block.relmse, 4 / 1.01 / (3 * 8 * 4));
    EXPECT_EQ(errors.max_error.x, 37u);
    EXPECT_EQ(errors.max_error.y, 18u);
    EXPECT_EQ(errors.max_error.channel, 1u);
    EXPECT_EQ(errors.max_error.error, 2);
    EXPECT_DOUBLE_EQ(errors.mse, 4.0 / (3 * 40 * 20));
}

/// Equal errors in several blocks: the one in the upper row comes first, whichever block it is in.
TEST(PixelErrors, TheFirstOfEqualErrorsIsNamed) {
    const auto spoiled = [](int x, int y, int) { return (x == 3 && y == 9) || (x == 30 && y == 2) ? 2.0f : 1.0f; };
    const PixelErrors errors = pixel_errors(hdr_pair(32, 32, spoiled, constant(vec3(1))));
    EXPECT_EQ(errors.max_error.x, 30u);
    EXPECT_EQ(errors.max_error.y, 2u);
    EXPECT_EQ(errors.worst_block.x, 0u);
}

TEST(PixelErrors, PixelsThatAreNotFiniteAreLeftOut) {
    const auto holes = [](int x, int, int c) { return x == 0 ? NAN : x == 1 && c == 2 ? -INFINITY : 2.0f; };
    const PixelErrors errors = pixel_errors(hdr_pair(4, 4, holes, constant(vec3(1))));
    EXPECT_EQ(errors.mse, 1);
    EXPECT_EQ(errors.test_mean, glm::dvec3(2));
    EXPECT_EQ(errors.reference_mean, glm::dvec3(1));
    EXPECT_EQ(errors.max_error.x, 2u);
}

/// Values near the end of float's range have squares beyond it.
TEST(PixelErrors, OfEnormousValuesAreFinite) {
    const PixelErrors errors = pixel_errors(hdr_pair(2, 2, constant(vec3(-3e38f)), constant(vec3(3e38f))));
    EXPECT_NEAR(errors.mse, 3.6e77, 1e71);
    EXPECT_TRUE(std::isfinite(errors.psnr));
}

}  // namespace
}  // namespace brandung
