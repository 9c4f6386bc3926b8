#include "scene/measures/heat_colour.h"

#include <gtest/gtest.h>

#include "scene/measures/colour.h"

namespace brandung {
namespace {

TEST(HeatColour, GrowsLighterWithTheValue) {
    double last = -1;
    for (int i = 0; i <= 1000; ++i) {
        const double lightness = lab(glm::dvec3(heat_colour(0.001f * float(i)))).x;
        EXPECT_GT(lightness, last) << i;
        last = lightness;
    }
    EXPECT_LT(lab(glm::dvec3(heat_colour(0))).x, 1) << "nearly black";
    EXPECT_GT(last, 95) << "nearly white";
}

/// Equal steps of the value are about equal steps of lightness.
TEST(HeatColour, IsEvenInLightness) {
    for (int i = 0; i < 10; ++i) {
        const double step = lab(glm::dvec3(heat_colour(0.1f * float(i + 1)))).x - lab(glm::dvec3(heat_colour(0.1f * float(i)))).x;
        EXPECT_GT(step, 6.5) << i;
        EXPECT_LT(step, 13) << i;
    }
}

TEST(HeatColour, ValuesBeyondAreClamped) {
    EXPECT_EQ(heat_colour(-1), heat_colour(0));
    EXPECT_EQ(heat_colour(2), heat_colour(1));
}

}  // namespace
}  // namespace brandung
