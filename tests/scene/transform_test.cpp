#include "scene/transform.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/support/scenes.h"

namespace brandung {
namespace {

glm::dvec3 applied(const AffineMap &map, glm::dvec3 p) { return map.linear * p + map.offset; }
glm::dvec3 applied(const Transform &m, vec3 p) {
    return glm::dvec3(m.x) * double(p.x) + glm::dvec3(m.y) * double(p.y) + glm::dvec3(m.z) * double(p.z) + glm::dvec3(m.origin);
}

TEST(Transform, StepsAreAppliedInOrder) {
    const AffineMap map = then(then(scaling({2, 3, 4}), rotation(90, {0, 0, 1})), translation({10, 0, 0}));
    EXPECT_EQ(applied(map, {1, 1, 1}), glm::dvec3(10 - 3, 2, 4));
}

TEST(Transform, QuarterTurnsAreExactAndCounterclockwise) {
    EXPECT_EQ(applied(rotation(90, {0, 0, 5}), {1, 0, 0}), glm::dvec3(0, 1, 0));
    EXPECT_EQ(applied(rotation(90, {2, 0, 0}), {0, 1, 0}), glm::dvec3(0, 0, 1));
    EXPECT_EQ(applied(rotation(90, {0, 1, 0}), {0, 0, 1}), glm::dvec3(1, 0, 0));
    EXPECT_EQ(applied(rotation(-90, {0, 0, 1}), {1, 0, 0}), glm::dvec3(0, -1, 0));
    EXPECT_EQ(applied(rotation(180, {0, 0, 1}), {1, 2, 3}), glm::dvec3(-1, -2, 3));
    EXPECT_EQ(applied(rotation(3600 + 270, {0, 0, -1}), {1, 0, 0}), glm::dvec3(0, 1, 0));
}

TEST(Transform, ARotationKeepsItsAxisAndLengths) {
    const AffineMap map = rotation(50, {1, 2, 3});
    EXPECT_LT(glm::distance(applied(map, {1, 2, 3}), glm::dvec3(1, 2, 3)), 1e-14);
    EXPECT_NEAR(glm::determinant(map.linear), 1, 1e-14);
    const glm::dvec3 across(3, 0, -1);  // at right angles to the axis
    EXPECT_NEAR(glm::dot(applied(map, across), across) / glm::dot(across, across), std::cos(50 * M_PI / 180), 1e-14);
}

/// |M M⁻¹ p - p|, both rounded to floats once: at most 2^-24 of the sum of the terms' magnitudes for each, in doubles.
TEST(Transform, TheInverseIsThatOfTheRoundedMap) {
    Random random(1);
    for (uint i = 0; i < 200; ++i) {
        const glm::dvec3 factors(std::exp2(random.uniform(-10, 10)), -std::exp2(random.uniform(-10, 10)), std::exp2(random.uniform(-10, 10)));
        const AffineMap map = then(then(rotation(random.uniform(0, 360), random.direction()), scaling(factors)), translation(random.in_cube(1)));
        const auto pair = make_transforms(map);
        ASSERT_TRUE(pair);
        const vec3 p = random.in_cube(1);
        const glm::dvec3 there = applied(pair->to_world, p), back = applied(pair->to_group, vec3(there));
        double size = 2;
        for (const vec3 &column : {pair->to_group.x, pair->to_group.y, pair->to_group.z})
            size += 3 * glm::length(glm::dvec3(column)) * glm::length(there);
        EXPECT_LE(glm::distance(back, glm::dvec3(p)), 0x1p-22 * size);
    }
}

/// As rows and columns of whole numbers, of which integers of 128 bits have the determinant and the minors exactly.
struct WholeMatrix {
    using wide = __int128;
    std::array<std::array<wide, 3>, 3> columns;

    wide minor(int column, int row) const {
        const auto &a = columns[(column + 1) % 3], &b = columns[(column + 2) % 3];
        return a[(row + 1) % 3] * b[(row + 2) % 3] - a[(row + 2) % 3] * b[(row + 1) % 3];
    }
    wide determinant() const { return columns[2][0] * minor(2, 0) + columns[2][1] * minor(2, 1) + columns[2][2] * minor(2, 2); }
};

/// Numbers up to 2^22, the third column being next to the plane of the others: nearest to it of 33^3 places, so that the determinant is about 2^-33
/// of its terms, of which doubles have 2^-53.
WholeMatrix all_but_flat(Random &random) {
    WholeMatrix m, best;
    const auto whole = [&] { return WholeMatrix::wide(random.uniform(-0x1p22f, 0x1p22f)); };
    for (int row = 0; row < 3; ++row) m.columns[0][row] = whole(), m.columns[1][row] = whole();
    double least = INFINITY;
    for (int place = 0; place < 33 * 33 * 33; ++place) {
        const int offsets[] = {place % 33 - 16, place / 33 % 33 - 16, place / 33 / 33 - 16};
        for (int row = 0; row < 3; ++row) m.columns[2][row] = (m.columns[0][row] + m.columns[1][row]) / 2 + offsets[row];
        const double size = std::abs(double(m.determinant()));
        if (size > 0 && size < least) least = size, best = m;
    }
    return best;
}

/// A coefficient has 2^-24 of itself from rounding to float.
TEST(Transform, TheInverseOfAnAllButFlatMapIsRoundedOnce) {
    Random random(2);
    for (uint i = 0; i < 10; ++i) {
        const WholeMatrix m = all_but_flat(random);
        AffineMap map;
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row) map.linear[column][row] = double(m.columns[column][row]);
        const auto pair = make_transforms(map);
        ASSERT_TRUE(pair);
        const vec3 columns[] = {pair->to_group.x, pair->to_group.y, pair->to_group.z};
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row) {
                const double exact = double(m.minor(row, column)) / double(m.determinant());
                EXPECT_NEAR(columns[column][row], exact, 0x1.001p-24 * std::abs(exact));
            }
    }
}

TEST(Transform, WhatHasNoInverseIsRefused) {
    const auto refused = [](const glm::dmat3 &linear, glm::dvec3 offset = {}) { return !make_transforms({linear, offset}); };
    EXPECT_FALSE(refused(glm::dmat3(1)));
    EXPECT_TRUE(refused(glm::dmat3(0)));
    EXPECT_TRUE(refused({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}})) << "a multiple of another";
    EXPECT_TRUE(refused({{1, 0, 0}, {0, 0.1, 0.2}, {0, 0.3, 0.6}})) << "in decimals";
    EXPECT_TRUE(refused(scaling(glm::dvec3(1e-16)).linear)) << "the inverse is beyond 1e15";
    EXPECT_TRUE(refused(scaling(glm::dvec3(1e16)).linear));
    EXPECT_TRUE(refused(glm::dmat3(1), {0, 2e15, 0}));
    EXPECT_TRUE(refused(scaling(glm::dvec3(1e-10)).linear, {1e6, 0, 0})) << "the group's origin is at 1e16 of its units";
    EXPECT_TRUE(refused(glm::dmat3(NAN)));
    EXPECT_FALSE(refused(scaling({1e-3, 1e3, -1e3}).linear));
    EXPECT_FALSE(refused(then(rotation(30, {1, 1, 0}), scaling({1e-3, 1e3, 1})).linear));
}

TEST(Transform, BoundsInTheWorldHoldAllCorners) {
    Random random(2);
    for (uint i = 0; i < 200; ++i) {
        const glm::dvec3 factors(std::exp2(random.uniform(-10, 10)), -std::exp2(random.uniform(-10, 10)), std::exp2(random.uniform(-10, 10)));
        const AffineMap map = then(then(scaling(factors), rotation(random.uniform(0, 360), random.direction())), translation(random.in_cube(100)));
        const auto pair = make_transforms(map);
        Bounds bounds;
        bounds.add(random.in_cube(1)), bounds.add(random.in_cube(1));
        const Bounds world = bounds_in_world(*pair, bounds);
        double slack = 0;
        glm::dvec3 low(INFINITY), high(-INFINITY);
        for (uint corner = 0; corner < 8; ++corner) {
            const vec3 p(corner & 1 ? bounds.low.x : bounds.high.x, corner & 2 ? bounds.low.y : bounds.high.y,
                         corner & 4 ? bounds.low.z : bounds.high.z);
            const glm::dvec3 there = applied(pair->to_world, p);
            low = glm::min(low, there), high = glm::max(high, there);
        }
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_LT(world.low[axis], low[axis]);
            EXPECT_GT(world.high[axis], high[axis]);
            slack = std::max(slack, (low[axis] - world.low[axis]) / (high[axis] - low[axis] + std::abs(low[axis])));
        }
        EXPECT_LT(slack, 0.01) << "tight";
    }
}

}  // namespace
}  // namespace brandung
