#include "scene/transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/parameters.h"

namespace brandung {
namespace {

/// Of matrices whose determinant is less than this part of the product of its rows' lengths, and of its columns', floats tell hardly anything.
constexpr double singular = 1e-12;

double product_of_lengths(const glm::dmat3 &m) { return glm::length(m[0]) * glm::length(m[1]) * glm::length(m[2]); }

/// A sum of twice a double's digits.
struct LongSum {
    double high = 0, low = 0;
    /// Knuth, The Art of Computer Programming 2, 4.2.2.
    void add(double x) {
        const double sum = high + x, part = sum - high;
        low += (high - (sum - part)) + (x - part);
        high = sum;
    }
    void add_product(double a, double b) {
        const double product = a * b;
        add(product);
        low += std::fma(a, b, -product);
    }
};

/// Of a matrix of floats, whose products are exact in double: right to the last digits however much its terms cancel.
double determinant(const glm::dmat3 &m) {
    LongSum sum;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        sum.add_product(m[0][i], m[1][j] * m[2][k]);
        sum.add_product(-m[0][i], m[1][k] * m[2][j]);
    }
    return sum.high + sum.low;
}

bool is_singular(const glm::dmat3 &m) {
    const double least = std::min(product_of_lengths(m), product_of_lengths(glm::transpose(m)));
    return !(std::abs(determinant(m)) > singular * least);
}

Transform rounded(const AffineMap &map) { return {vec3(map.linear[0]), vec3(map.linear[1]), vec3(map.linear[2]), vec3(map.offset)}; }

AffineMap exact(const Transform &transform) {
    return {{glm::dvec3(transform.x), glm::dvec3(transform.y), glm::dvec3(transform.z)}, glm::dvec3(transform.origin)};
}

/// Of a map of floats: the linear part by cofactors, which are differences of exact products.
AffineMap inverse(const AffineMap &map) {
    const auto &[x, y, z] = std::array{map.linear[0], map.linear[1], map.linear[2]};
    const glm::dmat3 linear = glm::transpose(glm::dmat3(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y))) / determinant(map.linear);
    return {linear, -(linear * map.offset)};
}

/// By magnitudes.
glm::dmat3 absolute(const glm::dmat3 &m) { return {glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2])}; }

bool in_range(const AffineMap &map) {
    const auto fits = [](const glm::dvec3 &v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) <= max_magnitude; };
    return fits(map.linear[0]) && fits(map.linear[1]) && fits(map.linear[2]) && fits(map.offset);
}

float rounded_down(double x) { return std::nextafter(float(x), -std::numeric_limits<float>::infinity()); }

AffineMap read_rotation(const Parameters &step) {
    const double degrees = step.number("rotate");
    const glm::dvec3 axis(step.vector("axis"));
    if (axis == glm::dvec3(0)) step.fail("axis", "must not be zero");
    return rotation(degrees, axis);
}

AffineMap read_scaling(const Parameters &step) {
    const glm::dvec3 factors(step.factors("scale"));
    if (factors.x * factors.y * factors.z == 0) step.fail("scale", "must not be zero: nothing of the group would be left");
    return scaling(factors);
}

AffineMap read_matrix(const Parameters &step) {
    const std::vector<float> rows = step.numbers("matrix", 12);
    AffineMap map;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) map.linear[column][row] = rows[std::size_t(4 * row + column)];
        map.offset[row] = rows[std::size_t(4 * row + 3)];
    }
    return map;
}

AffineMap read_step(const Parameters &step) {
    const char *const names[] = {"translate", "scale", "rotate", "matrix"};
    if (std::count_if(std::begin(names), std::end(names), [&](const char *name) { return step.has(name); }) != 1)
        step.fail("", "a step of a transform is one of translate, scale, rotate, matrix");
    const AffineMap map = step.has("translate") ? translation(step.vector("translate"))
                          : step.has("scale")   ? read_scaling(step)
                          : step.has("rotate")  ? read_rotation(step)
                                                : read_matrix(step);
    step.expect_all_known();
    return map;
}

}  // namespace

AffineMap then(const AffineMap &first, const AffineMap &second) {
    return {second.linear * first.linear, second.linear * first.offset + second.offset};
}

AffineMap translation(glm::dvec3 by) { return {glm::dmat3(1), by}; }

AffineMap scaling(glm::dvec3 by) { return {{{by.x, 0, 0}, {0, by.y, 0}, {0, 0, by.z}}, glm::dvec3(0)}; }

AffineMap rotation(double degrees, glm::dvec3 axis) {
    const double quarters = std::nearbyint(degrees / 90), rest = (degrees - 90 * quarters) * glm::pi<double>() / 180;
    double cosine = std::cos(rest), sine = std::sin(rest);
    for (double turns = std::fmod(std::fmod(quarters, 4) + 4, 4); turns > 0; --turns) {
        const double before = cosine;
        cosine = -sine, sine = before;
    }
    const glm::dvec3 n = glm::normalize(axis), across = (1 - cosine) * n;
    return {{{across.x * n.x + cosine, across.x * n.y + sine * n.z, across.x * n.z - sine * n.y},
             {across.y * n.x - sine * n.z, across.y * n.y + cosine, across.y * n.z + sine * n.x},
             {across.z * n.x + sine * n.y, across.z * n.y - sine * n.x, across.z * n.z + cosine}},
            glm::dvec3(0)};
}

AffineMap read_transform(const Parameters &parameters) {
    AffineMap map;
    for (const Parameters &step : parameters.one_or_more("transform")) map = then(map, read_step(step));
    return map;
}

std::optional<TransformPair> make_transforms(const AffineMap &map) {
    if (!in_range(map)) return {};
    const Transform to_world = rounded(map);
    const AffineMap used = exact(to_world);
    if (is_singular(used.linear)) return {};
    const AffineMap back = inverse(used);
    if (!in_range(back)) return {};
    return TransformPair{to_world, rounded(back)};
}

/// A ray's origin o has an error of at most 2^-22 (|M⁻¹| |o| + |t'|) in the group's space, of which a box's pad covers what is due to the ray's
/// distance; what is due to the transforms is added here, twice.
Bounds bounds_in_world(const TransformPair &transforms, const Bounds &bounds) {
    const AffineMap to_world = exact(transforms.to_world), to_group = exact(transforms.to_group);
    const glm::dvec3 center = (glm::dvec3(bounds.low) + glm::dvec3(bounds.high)) / 2.0, half = glm::dvec3(bounds.high) - center;
    const glm::dvec3 place = to_world.linear * center + to_world.offset, reach = absolute(to_world.linear) * half;
    const glm::dvec3 farthest = glm::abs(place) + reach;
    const glm::dvec3 rounding = absolute(to_world.linear) * (absolute(to_group.linear) * farthest + glm::abs(to_group.offset)) + farthest;
    const glm::dvec3 size = reach + 0x1p-21 * rounding;
    Bounds result;
    for (int axis = 0; axis < 3; ++axis) {
        result.low[axis] = rounded_down(place[axis] - size[axis]);
        result.high[axis] = -rounded_down(-(place[axis] + size[axis]));
    }
    return result;
}

}  // namespace brandung
