#include "scene/measures/ssim.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/scene/measures/pictures.h"

namespace brandung {
namespace {

double luma(const vec3 &v) { return 0.2126 * v.x + 0.7152 * v.y + 0.0722 * v.z; }

/// SSIM of the window round a pixel as the paper defines it: means, then squared distances from them.
double window_ssim(const PicturePair &pair, int cx, int cy) {
    double weights = 0, a_mean = 0, b_mean = 0, a_variance = 0, b_variance = 0, covariance = 0;
    const auto each = [&](const auto &visit) {
        for (int y = cy - 5; y <= cy + 5; ++y)
            for (int x = cx - 5; x <= cx + 5; ++x) {
                const std::size_t i = std::size_t(y) * pair.width + std::size_t(x);
                visit(std::exp(-((x - cx) * (x - cx) + (y - cy) * (y - cy)) / (2 * 1.5 * 1.5)), luma(pair.test[i]), luma(pair.reference[i]));
            }
    };
    each([&](double w, double a, double b) { weights += w, a_mean += w * a, b_mean += w * b; });
    a_mean /= weights, b_mean /= weights;
    each([&](double w, double a, double b) {
        a_variance += w / weights * (a - a_mean) * (a - a_mean);
        b_variance += w / weights * (b - b_mean) * (b - b_mean);
        covariance += w / weights * (a - a_mean) * (b - b_mean);
    });
    const double c1 = 1e-4, c2 = 9e-4;
    return (2 * a_mean * b_mean + c1) * (2 * covariance + c2) / ((a_mean * a_mean + b_mean * b_mean + c1) * (a_variance + b_variance + c2));
}

TEST(Ssim, IsTheMeanOfTheWindowsThatLieInThePicture) {
    const PicturePair pair = ldr_pair(17, 13, grainy_ramp, board);
    double sum = 0;
    for (int y = 5; y < 8; ++y)
        for (int x = 5; x < 12; ++x) sum += window_ssim(pair, x, y);
    EXPECT_NEAR(*ssim(pair), sum / (3 * 7), 1e-9);
}

/// scikit-image 0.26: structural_similarity(gaussian_weights=True, sigma=1.5, use_sample_covariance=False, data_range=1), of luma.
TEST(Ssim, AgreesWithScikitImage) {
    EXPECT_NEAR(*ssim(ldr_pair(32, 24, grainy_ramp, ramp)), 0.853798, 2e-6);
    EXPECT_NEAR(*ssim(ldr_pair(32, 24, shifted_board, board)), 0.499661, 2e-6);
    EXPECT_NEAR(*ssim(ldr_pair(32, 24, board, ramp)), 0.034597, 2e-6);
}

TEST(Ssim, OfEqualPicturesIsOne) { EXPECT_EQ(*ssim(ldr_pair(20, 20, board, board)), 1); }

/// Without structure only the means count: (2 a b + c1) / (a^2 + b^2 + c1).
TEST(Ssim, OfUniformPicturesComparesTheirBrightness) {
    const double a = 0.2, b = 0.6, c1 = 1e-4;
    EXPECT_NEAR(*ssim(ldr_pair(11, 11, constant(vec3(51)), constant(vec3(153)))), (2 * a * b + c1) / (a * a + b * b + c1), 1e-6);
}

TEST(Ssim, NeedsAWindow) {
    EXPECT_FALSE(ssim(ldr_pair(10, 20, board, ramp)));
    EXPECT_FALSE(ssim(ldr_pair(20, 10, board, ramp)));
    const auto hole = [](int x, int y, int) { return x == 5 && y == 5 ? NAN : 1.0f; };
    EXPECT_FALSE(ssim(hdr_pair(11, 11, hole, waves))) << "the only window has no centre";
}

/// HDR pictures are compared as they are shown at exposure 0: 3 and 5 are both white.
TEST(Ssim, OfHdrPicturesIsThatOfWhatIsShown) { EXPECT_EQ(*ssim(hdr_pair(12, 12, constant(vec3(3)), constant(vec3(5)))), 1); }

}  // namespace
}  // namespace brandung
