/// runtime/selftest/roots.h: what rounding explains and what it does not.
#include <gtest/gtest.h>

#include <limits>

#include "runtime/selftest/roots.h"

namespace brandung {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

bool is_right(const std::vector<Root> &roots, Crossed crossed, float t_max = infinity) { return judge(roots, crossed, t_max).fault.empty(); }

const std::vector<Root> two = {{1, 0.1, true}, {3, 0.1, true}};

TEST(Judge, TheFirstSureRootMustBeMetWithinItsError) {
    EXPECT_TRUE(is_right(two, {true, 1}));
    EXPECT_TRUE(is_right(two, {true, 1.09f}));
    EXPECT_FALSE(is_right(two, {true, 1.11f}));
    EXPECT_FALSE(is_right(two, {true, 3})) << "overlooks the first";
    EXPECT_FALSE(is_right(two, {false, 0}));
    EXPECT_FALSE(is_right({}, {true, 1})) << "made up";
    EXPECT_TRUE(is_right({}, {false, 0}));
}

TEST(Judge, WhatIsNotSureMayBeMetOrNot) {
    const std::vector<Root> roots = {{1, 0.1, false}, {3, 0.1, true}};
    EXPECT_TRUE(is_right(roots, {true, 1}));
    EXPECT_TRUE(is_right(roots, {true, 3}));
    EXPECT_FALSE(is_right(roots, {false, 0}));
    EXPECT_TRUE(judge(roots, {true, 1}, infinity).ambiguous);
    EXPECT_FALSE(judge(two, {true, 1}, infinity).ambiguous);
}

TEST(Judge, BothEndsOfTheRayAreAsWideAsTheError) {
    EXPECT_TRUE(is_right({{0.05, 0.1, true}}, {false, 0}));
    EXPECT_TRUE(is_right({{-0.05, 0.1, true}}, {true, 0.04f}));
    EXPECT_FALSE(is_right({{-0.05, 0.1, true}}, {true, -0.04f})) << "t is never negative";
    EXPECT_TRUE(is_right({{1, 0.1, true}}, {false, 0}, 1.05f));
    EXPECT_TRUE(is_right({{1, 0.1, true}}, {false, 0}, 0.5f));
    EXPECT_FALSE(is_right({{1, 0.1, true}}, {false, 0}, 1.2f));
    EXPECT_FALSE(is_right({{1, 0.1, true}}, {true, 1}, 0.9f)) << "beyond its end";
}

TEST(Judge, ASideThatIsDecidedWithMoreCareIsHeldToThat) {
    const std::vector<Root> before = {{0.05, 0.1, true, 0.01}}, behind = {{-0.05, 0.1, true, 0.01}}, on = {{0.005, 0.1, true, 0.01}};
    EXPECT_FALSE(is_right(before, {false, 0})) << "overlooked, though t may be off by more";
    EXPECT_TRUE(is_right(before, {true, 0.14f}));
    EXPECT_FALSE(is_right(behind, {true, 0.04f})) << "it lies behind";
    EXPECT_TRUE(is_right(behind, {false, 0}));
    EXPECT_TRUE(is_right(on, {false, 0}));
    EXPECT_TRUE(is_right(on, {true, 0.01f}));
    EXPECT_FALSE(judge(before, {true, 0.05f}, infinity).ambiguous);
    EXPECT_TRUE(judge(on, {true, 0.05f}, infinity).ambiguous);
}

TEST(Judge, EightUlpAreAlwaysAllowed) {
    EXPECT_TRUE(is_right({{1, 0, true}}, {true, 1 + 8 * 0x1p-23f}));
    EXPECT_FALSE(is_right({{1, 0, true}}, {true, 1 + 9 * 0x1p-23f}));
}

}  // namespace
}  // namespace brandung
