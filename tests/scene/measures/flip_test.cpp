#include "scene/measures/flip.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "tests/scene/measures/pictures.h"

namespace brandung {
namespace {

double mean_flip(const PicturePair &pair, double pixels_per_degree = default_pixels_per_degree) { return flip(pair, pixels_per_degree).mean; }

/// The authors' flip-evaluator 1.7, on the same values. It computes in single precision: roots of features that are nearly equal make 1e-4 of that.
constexpr double evaluator_rounding = 1e-4;

TEST(Flip, AgreesWithTheAuthorsEvaluatorOnLdrPictures) {
    EXPECT_NEAR(mean_flip(ldr_pair(32, 24, grainy_ramp, ramp)), 0.215713, evaluator_rounding);
    EXPECT_NEAR(mean_flip(ldr_pair(32, 24, shifted_board, board)), 0.201397, evaluator_rounding);
    EXPECT_NEAR(mean_flip(ldr_pair(32, 24, board, ramp)), 0.676031, evaluator_rounding);
}

TEST(Flip, AgreesWithTheAuthorsEvaluatorAtOtherDistances) {
    EXPECT_NEAR(mean_flip(ldr_pair(32, 24, grainy_ramp, ramp), 20), 0.252520, evaluator_rounding);
    EXPECT_NEAR(mean_flip(ldr_pair(32, 24, shifted_board, board), 20), 0.339063, evaluator_rounding);
}

TEST(Flip, AgreesWithTheAuthorsEvaluatorOnHdrPictures) {
    const Flip grain = flip(hdr_pair(32, 24, grainy_waves, waves), default_pixels_per_degree);
    EXPECT_NEAR(grain.mean, 0.143085, evaluator_rounding);
    EXPECT_NEAR(grain.exposures.start, -0.745405, 1e-4);
    EXPECT_NEAR(grain.exposures.stop, 0.202827, 1e-4);
    EXPECT_EQ(grain.exposures.count, 2u);
    EXPECT_NEAR(mean_flip(hdr_pair(32, 24, waves_with_fireflies, waves)), 0.042237, evaluator_rounding);
}

TEST(Flip, OfEqualPicturesIsZero) {
    EXPECT_EQ(mean_flip(ldr_pair(32, 24, board, board)), 0);
    EXPECT_EQ(mean_flip(hdr_pair(32, 24, waves, waves)), 0);
}

/// The greatest distance of colours, without features.
TEST(Flip, OfGreenAndBlueIsOne) { EXPECT_NEAR(mean_flip(ldr_pair(8, 8, constant({0, 255, 0}), constant({0, 0, 255}))), 1, 1e-6); }

/// Black and white are 100 apart. Green has L*a*b* (87.735, -86.183, 83.180) and blue (32.297, 79.188, -107.860); with chroma times L*/100 they are
/// |87.735 - 32.297| + |(-75.613 - 25.575, 72.978 + 34.836)| = 203.299 apart. Of that, as of 100, the power 0.7 counts; from 0.4 of the greatest on
/// the rest is mapped to the last 0.05.
TEST(Flip, OfBlackAndWhiteIsThatOfTheirDistance) {
    const double greatest = std::pow(203.299, 0.7), difference = std::pow(100, 0.7);
    EXPECT_NEAR(mean_flip(ldr_pair(8, 8, constant(vec3(0)), constant(vec3(255)))), 0.95 + 0.05 * (difference - 0.4 * greatest) / (0.6 * greatest),
                1e-5);
}

TEST(Flip, IsTheSameBothWays) {
    const Flip there = flip(ldr_pair(32, 24, grainy_ramp, board), 40), back = flip(ldr_pair(32, 24, board, grainy_ramp), 40);
    EXPECT_EQ(there.map, back.map);
}

/// From afar a fine pattern and its mean look alike.
TEST(Flip, OfFinePatternsFallsWithDistance) {
    const auto fine = [](int x, int y, int) { return (x + y) % 2 == 0 ? 200.0f : 50.0f; };
    const auto other = [](int x, int y, int) { return (x + y) % 2 == 0 ? 50.0f : 200.0f; };
    EXPECT_LT(mean_flip(ldr_pair(32, 24, fine, other), 300), 0.5 * mean_flip(ldr_pair(32, 24, fine, other), 15));
}

TEST(Flip, IsTheSameForAnyNumberOfThreads) {
    const auto map = [](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return flip(hdr_pair(64, 48, grainy_waves, waves), default_pixels_per_degree);
    };
    const Flip one = map(1), many = map(8);
    EXPECT_EQ(one.map, many.map);
    EXPECT_EQ(one.mean, many.mean);
}

/// Extremes of linear light: all black references, enormous and negative values.
TEST(Flip, IsFiniteForAllFinitePictures) {
    const auto extremes = [](int x, int y, int) { return x < 4 ? -3e38f : y < 4 ? 3e38f : 1e-38f; };
    for (const Flip &result : {flip(hdr_pair(16, 16, extremes, waves), 67), flip(hdr_pair(16, 16, waves, extremes), 67),
                               flip(hdr_pair(16, 16, waves, constant(vec3(0))), 67), flip(hdr_pair(1, 1, constant(vec3(2)), constant(vec3(1))), 67)})
        for (const float difference : result.map) {
            ASSERT_GE(difference, 0);
            ASSERT_LE(difference, 1);
        }
}

/// Both pictures are black there, and the mean leaves them out.
TEST(Flip, LeavesOutPixelsThatAreNotFinite) {
    const auto hole = [](int x, int y, int) { return x == 0 && y == 0 ? NAN : 1.0f; };
    EXPECT_EQ(mean_flip(hdr_pair(16, 16, hole, constant(vec3(1)))), 0);
}

}  // namespace
}  // namespace brandung
