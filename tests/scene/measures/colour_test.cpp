#include "scene/measures/colour.h"

#include <gtest/gtest.h>

namespace brandung {
namespace {

void expect_near(const glm::dvec3 &a, const glm::dvec3 &b, double tolerance) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << "channel " << c;
}

/// Greys have no chroma; of a luminance above (6/29)^3 their lightness is 116 Y^(1/3) - 16, below it Y 29^3/27.
TEST(Colour, LabOfGreys) {
    expect_near(lab({1, 1, 1}), {100, 0, 0}, 1e-9);
    expect_near(lab({0.125, 0.125, 0.125}), {42, 0, 0}, 1e-9);
    expect_near(lab({0.001, 0.001, 0.001}), {0.9032963, 0, 0}, 1e-6);
    expect_near(lab({0, 0, 0}), {0, 0, 0}, 1e-9);
}

/// Known of sRGB's primaries: L*a*b* of green is (87.73, -86.18, 83.18), of blue (32.30, 79.19, -107.86); luminances of Rec. 709.
TEST(Colour, LabAndLuminanceOfPrimaries) {
    expect_near(lab({0, 1, 0}), {87.735, -86.183, 83.180}, 0.01);
    expect_near(lab({0, 0, 1}), {32.297, 79.188, -107.860}, 0.01);
    EXPECT_NEAR(luminance({1, 0, 0}), 0.2126, 1e-4);
    EXPECT_NEAR(luminance({0, 1, 0}), 0.7152, 1e-4);
    EXPECT_NEAR(luminance({0, 0, 1}), 0.0722, 1e-4);
}

/// Lightness is 116 Y - 16; X / Xn and Z / Zn of blue are 0.1805 / 0.9505 and 0.9505 / 1.0888.
TEST(Colour, OpponentIsLinearInLight) {
    expect_near(opponent({1, 1, 1}), {100, 0, 0}, 1e-9);
    expect_near(opponent({0, 0, 1}), {116 * 0.0722 - 16, 500 * (0.18990 - 0.0722), 200 * (0.0722 - 0.87298)}, 0.05);
    expect_near(from_opponent(opponent({0.3, 0.7, 0.1})), {0.3, 0.7, 0.1}, 1e-12);
}

}  // namespace
}  // namespace brandung
