#include "scene/motion_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace brandung {
namespace {

constexpr double millionth = 0x1p-20;
constexpr std::size_t most_parts = 4096;

/// Coefficients of 1, s, s², s³.
using Polynomial = std::array<AffineMap, MOTION_TERMS>;

AffineMap sum(const AffineMap &a, double wa, const AffineMap &b, double wb) { return {wa * a.linear + wb * b.linear, wa * a.offset + wb * b.offset}; }

AffineMap combination(const Polynomial &maps, const std::array<double, MOTION_TERMS> &weights) {
    AffineMap result = sum(maps[0], weights[0], maps[1], weights[1]);
    for (std::size_t k = 2; k < MOTION_TERMS; ++k) result = sum(result, 1, maps[k], weights[k]);
    return result;
}

/// Through the values at s = 0, 1/3, 2/3, 1.
Polynomial interpolation(const Polynomial &values) {
    return {values[0], combination(values, {-5.5, 9, -4.5, 1}), combination(values, {9, -22.5, 18, -4.5}),
            combination(values, {-4.5, 13.5, -13.5, 4.5})};
}

AffineMap value_at(const Polynomial &p, double s) { return combination(p, {1, s, s * s, s * s * s}); }

glm::dmat3 absolute(const glm::dmat3 &m) { return {glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2])}; }
AffineMap absolute(const AffineMap &m) { return {absolute(m.linear), glm::abs(m.offset)}; }

/// What the terms' magnitudes come to: no value in the part is larger.
AffineMap magnitude(const Polynomial &p) {
    AffineMap result = absolute(p[0]);
    for (std::size_t k = 1; k < MOTION_TERMS; ++k) result = sum(result, 1, absolute(p[k]), 1);
    return result;
}

glm::dvec3 applied(const AffineMap &map, const glm::dvec3 &p) { return map.linear * p + map.offset; }
double largest(const glm::dvec3 &v) { return std::max({v.x, v.y, v.z}); }

/// From the origin, along each axis.
glm::dvec3 reach_of(const Bounds &bounds) { return glm::max(glm::abs(glm::dvec3(bounds.low)), glm::abs(glm::dvec3(bounds.high))); }

AffineMap inverse_of(const AffineMap &map) {
    const glm::dmat3 linear = glm::inverse(map.linear);
    return {linear, -(linear * map.offset)};
}

/// Whether the polynomial moves what is within reach to where it should be at s.
bool fits(const Polynomial &p, double s, const AffineMap &wanted, const glm::dvec3 &reach) {
    const AffineMap error = absolute(sum(value_at(p, s), 1, wanted, -1));
    return largest(applied(error, reach)) <= millionth * largest(applied(absolute(wanted), reach));
}

Polynomial exact(const Transform (&terms)[MOTION_TERMS]) {
    Polynomial p;
    for (std::size_t k = 0; k < MOTION_TERMS; ++k)
        p[k] = {{glm::dvec3(terms[k].x), glm::dvec3(terms[k].y), glm::dvec3(terms[k].z)}, glm::dvec3(terms[k].origin)};
    return p;
}

void round_to(const Polynomial &p, Transform (&terms)[MOTION_TERMS]) {
    for (std::size_t k = 0; k < MOTION_TERMS; ++k) terms[k] = {vec3(p[k].linear[0]), vec3(p[k].linear[1]), vec3(p[k].linear[2]), vec3(p[k].offset)};
}

/// Binomial coefficient.
double choose(std::size_t n, std::size_t k) { return k == 0 ? 1 : choose(n - 1, k - 1) * static_cast<double>(n) / static_cast<double>(k); }

/// The control points of a polynomial of s from 0 to 1 (Bernstein): none of its values lies outside of their convex hull.
template <std::size_t size> std::array<AffineMap, size> control_points(const std::array<AffineMap, size> &terms) {
    std::array<AffineMap, size> points;
    for (std::size_t j = 0; j < size; ++j) {
        points[j] = {glm::dmat3(0), glm::dvec3(0)};
        for (std::size_t k = 0; k <= j; ++k) points[j] = sum(points[j], 1, terms[k], choose(j, k) / choose(size - 1, k));
    }
    return points;
}

/// Part by which a value that a kernel computes differs from the polynomial's, of magnitude(): three roundings.
constexpr double rounding = 0x1p-22;

/// By how much `to_group` after `to_world`, as kernels compute them, differ from the identity at most.
AffineMap mismatch_of(const Polynomial &to_world, const Polynomial &to_group) {
    std::array<AffineMap, 2 * MOTION_TERMS - 1> product;
    product.fill({glm::dmat3(0), glm::dvec3(0)});
    for (std::size_t i = 0; i < MOTION_TERMS; ++i) {
        product[i].offset += to_group[i].offset;
        for (std::size_t j = 0; j < MOTION_TERMS; ++j) {
            product[i + j].linear += to_group[i].linear * to_world[j].linear;
            product[i + j].offset += to_group[i].linear * to_world[j].offset;
        }
    }
    product[0].linear -= glm::dmat3(1);
    AffineMap most = {glm::dmat3(0), glm::dvec3(0)};
    for (const AffineMap &point : control_points(product)) {
        for (int column = 0; column < 3; ++column) most.linear[column] = glm::max(most.linear[column], glm::abs(point.linear[column]));
        most.offset = glm::max(most.offset, glm::abs(point.offset));
    }
    const AffineMap m = magnitude(to_world), g = magnitude(to_group);
    const AffineMap rounded = {2.0 * (g.linear * m.linear), 2.0 * (g.linear * m.offset) + g.offset};
    return sum(most, 1.001, rounded, 1.001 * rounding);
}

/// Of times from a to b, where the map changes smoothly; nothing if polynomials do not fit.
std::optional<MotionPart> make_part(const Motion &motion, double a, double b, const Shutter &shutter, const glm::dvec3 &reach) {
    Polynomial maps, inverses;
    glm::dvec3 there(0);
    for (std::size_t k = 0; k < MOTION_TERMS; ++k) {
        maps[k] = motion.at(k == MOTION_TERMS - 1 ? b : a + (b - a) * static_cast<double>(k) / (MOTION_TERMS - 1));
        inverses[k] = inverse_of(maps[k]);
        there = glm::max(there, applied(absolute(maps[k]), reach));
    }
    const Polynomial to_world = interpolation(maps), to_group = interpolation(inverses);
    for (const double s : {1.0 / 6, 0.5, 5.0 / 6}) {
        const AffineMap wanted = motion.at(a + s * (b - a));
        if (!fits(to_world, s, wanted, reach) || !fits(to_group, s, inverse_of(wanted), there)) return {};
    }
    MotionPart part{};
    part.begin = shutter.place_of(a);
    part.rate = 1 / (shutter.place_of(b) - part.begin);
    round_to(to_world, part.to_world), round_to(to_group, part.to_group);
    const AffineMap mismatch = mismatch_of(exact(part.to_world), exact(part.to_group));
    part.mismatch = {vec3(mismatch.linear[0]), vec3(mismatch.linear[1]), vec3(mismatch.linear[2]), vec3(mismatch.offset)};
    return part;
}

/// False if there are too many.
bool add_parts(const Motion &motion, double a, double b, const Shutter &shutter, const glm::dvec3 &reach, std::vector<MotionPart> &parts) {
    if (shutter.place_of(a) == shutter.place_of(b)) return true;
    if (const auto part = make_part(motion, a, b, shutter, reach)) {
        parts.push_back(*part);
        return parts.size() <= most_parts;
    }
    const double middle = a + (b - a) / 2;
    if (shutter.place_of(middle) == shutter.place_of(a) || shutter.place_of(middle) == shutter.place_of(b)) return false;
    return add_parts(motion, a, middle, shutter, reach, parts) && add_parts(motion, middle, b, shutter, reach, parts);
}

float rounded_down(double x) { return std::nextafter(float(x), -std::numeric_limits<float>::infinity()); }

/// A point w of a ray is met at p, to which kernels bring it and which lies in the group's bounds. The map to the world takes p to within the
/// mismatch of w, and its value is a mean of its control points. What rounding of a ray's origin adds is as for groups at rest.
void add_bounds(const MotionPart &part, const Bounds &bounds, Bounds &result) {
    const Polynomial to_world = exact(part.to_world), to_group = exact(part.to_group);
    const AffineMap m = magnitude(to_world), g = magnitude(to_group);
    const AffineMap mismatch = {{glm::dvec3(part.mismatch.x), glm::dvec3(part.mismatch.y), glm::dvec3(part.mismatch.z)},
                                glm::dvec3(part.mismatch.origin)};
    const glm::dvec3 center = (glm::dvec3(bounds.low) + glm::dvec3(bounds.high)) / 2.0, reach = reach_of(bounds);
    const glm::dvec3 half = glm::dvec3(bounds.high) - center + 2.0 * applied(mismatch, reach);
    const glm::dvec3 farthest = applied(m, reach + half);
    const glm::dvec3 terms = m.linear * applied(g, farthest) + farthest;
    const glm::dvec3 slack = 0x1p-21 * terms + rounding * farthest;
    for (const AffineMap &point : control_points(to_world)) {
        const glm::dvec3 place = applied(point, center), size = absolute(point.linear) * half + slack;
        for (int axis = 0; axis < 3; ++axis) {
            result.low[axis] = std::min(result.low[axis], rounded_down(place[axis] - size[axis]));
            result.high[axis] = std::max(result.high[axis], -rounded_down(-(place[axis] + size[axis])));
        }
    }
}

}  // namespace

std::optional<std::vector<MotionPart>> motion_parts(const Motion &motion, const Shutter &shutter, const Bounds &bounds) {
    std::vector<MotionPart> parts;
    const std::vector<double> times = motion.breaks(shutter);
    for (std::size_t k = 1; k < times.size(); ++k)
        if (!add_parts(motion, times[k - 1], times[k], shutter, reach_of(bounds), parts)) return {};
    return parts;
}

Bounds bounds_in_world(const std::vector<MotionPart> &parts, const Bounds &bounds) {
    Bounds result;
    for (const MotionPart &part : parts) add_bounds(part, bounds, result);
    return result;
}

}  // namespace brandung
