#include "scene/accelerators/volume_fit.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

namespace brandung {
namespace {

using Vector = glm::dvec3;

constexpr double outward = 1 + 1e-6;  ///< makes up for the rounding to float

/// Lowest and highest p·n.
struct Extent {
    double low = DBL_MAX, high = -DBL_MAX;
    double middle() const { return (low + high) / 2; }
    double half() const { return (high - low) / 2; }
};

Extent extent_along(std::span<const HullPart> parts, Vector n) {
    Extent extent;
    for (const HullPart &part : parts) {
        const double at = glm::dot(n, Vector(part.center));
        double reach = 0;
        if (part.radius > 0) {
            const double along_axis = glm::dot(n, Vector(part.axis));
            reach = part.radius * std::sqrt(std::max(0.0, glm::dot(n, n) - along_axis * along_axis));
        }
        extent.low = std::min(extent.low, at - reach), extent.high = std::max(extent.high, at + reach);
    }
    return extent;
}

void put(Volume &volume, std::size_t word, Vector v) {
    for (int i = 0; i < 3; ++i) volume.words[word + std::size_t(i)] = float(v[i]);
}

Vector stored(const Volume &volume, std::size_t word) { return {volume.words[word], volume.words[word + 1], volume.words[word + 2]}; }

Vector middle_of(std::span<const HullPart> parts) {
    Vector middle;
    for (int axis = 0; axis < 3; ++axis) {
        Vector n(0);
        n[axis] = 1;
        middle[axis] = extent_along(parts, n).middle();
    }
    return middle;
}

/// The direction that repeated multiplication by a symmetric matrix turns everything to, from `v` on.
Vector principal(const glm::dmat3 &matrix, Vector v) {
    for (int i = 0; i < 24; ++i) {
        const Vector next = matrix * v;
        const double length = glm::length(next);
        if (!(length > 1e-300)) break;
        v = next / length;
    }
    return glm::normalize(v);
}

/// Along which the parts' centres lie farthest apart, and across.
std::array<Vector, 3> axes_of(std::span<const HullPart> parts) {
    Vector mean(0);
    for (const HullPart &part : parts) mean += Vector(part.center);
    mean /= double(parts.size());
    glm::dmat3 covariance(0);
    double scale = 0;
    for (const HullPart &part : parts) {
        const Vector v = Vector(part.center) - mean;
        covariance += glm::outerProduct(v, v);
        scale += glm::dot(v, v);
        // A disc is wide across its axis.
        if (part.axis != vec3(0))
            covariance += 0.25 * part.radius * part.radius * (glm::dmat3(1) - glm::outerProduct(Vector(part.axis), Vector(part.axis)));
    }
    covariance /= std::max(scale, 1e-300);
    const Vector first = principal(covariance, Vector(0.8, 0.5, 0.3));
    const Vector helper = std::abs(first.x) < 0.6 ? Vector(1, 0, 0) : Vector(0, 1, 0);
    const glm::dmat3 rest = covariance - glm::dot(first, covariance * first) * glm::outerProduct(first, first);
    Vector second = principal(rest, glm::normalize(glm::cross(first, helper)));
    second = glm::normalize(second - first * glm::dot(first, second));
    return {first, second, glm::cross(first, second)};
}

Volume fit_sphere(std::span<const HullPart> parts) {
    Volume volume{};
    put(volume, 0, middle_of(parts));
    double radius = 0;
    for (const HullPart &part : parts) radius = std::max(radius, glm::distance(Vector(part.center), stored(volume, 0)) + part.radius);
    volume.words[3] = float(radius * outward);
    return volume;
}

Volume fit_oriented_box(std::span<const HullPart> parts) {
    Volume volume{};
    const std::array<Vector, 3> axes = axes_of(parts);
    Vector center(0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        put(volume, 3 + 3 * axis, axes[axis]);
        center += axes[axis] * extent_along(parts, axes[axis]).middle();
    }
    put(volume, 0, center);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Vector n = stored(volume, 3 + 3 * axis);
        const Extent extent = extent_along(parts, n);
        const double middle = glm::dot(n, stored(volume, 0));
        volume.words[12 + axis] = float(std::max(extent.high - middle, middle - extent.low) * outward);
    }
    return volume;
}

/// The oriented box's proportions, and as large as its farthest part wants it.
Volume fit_ellipsoid(std::span<const HullPart> parts, const Volume &box) {
    std::array<Vector, 3> rows;
    const double longest = std::max({box.words[12], box.words[13], box.words[14]});
    double stretch = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double half = std::max(double(box.words[12 + axis]), std::max(1e-3 * longest, 1e-30));
        rows[axis] = stored(box, 3 + 3 * axis) / half;
        stretch = std::max(stretch, glm::length(rows[axis]));
    }
    const Vector center = stored(box, 0);
    double size = 0;
    for (const HullPart &part : parts) {
        const Vector v = Vector(part.center) - center;
        size = std::max(size, glm::length(Vector(glm::dot(rows[0], v), glm::dot(rows[1], v), glm::dot(rows[2], v))) + part.radius * stretch);
    }
    size = std::max(size, 1e-30) * outward;
    Volume volume{};
    put(volume, 0, center);
    for (std::size_t axis = 0; axis < 3; ++axis) put(volume, 3 + 3 * axis, rows[axis] / size);
    volume.words[12] = float(stretch / size * outward);
    return volume;
}

const std::array<Vector, 4> diagonals = {Vector(1, 1, 1), Vector(1, 1, -1), Vector(1, -1, 1), Vector(-1, 1, 1)};

Volume fit_diagonals(std::span<const HullPart> parts) {
    Volume volume{};
    for (std::size_t i = 0; i < diagonals.size(); ++i) {
        const Extent extent = extent_along(parts, diagonals[i]);
        volume.words[2 * i] = float(extent.low), volume.words[2 * i + 1] = float(extent.high);
    }
    return volume;
}

struct Line {
    Vector origin, direction;
};

double squared_distance(Vector f, Vector d) {
    const Vector across = f - d * (glm::dot(f, d) / glm::dot(d, d));
    return glm::dot(across, across);
}

struct Stretch {
    double near = -DBL_MAX, far = DBL_MAX;
    void cut(double low, double high, double at, double rate) {
        if (rate == 0) {
            if (at < low || at > high) near = DBL_MAX;
            return;
        }
        const double a = (low - at) / rate, b = (high - at) / rate;
        near = std::max(near, std::min(a, b)), far = std::min(far, std::max(a, b));
    }
    bool exists() const { return near <= far; }
};

bool meets(uint kind, const Volume &volume, const Line &line, Stretch stretch) {
    const float *w = volume.words;
    const Vector f = line.origin - stored(volume, 0);
    if (kind == VOLUME_SPHERE) return squared_distance(f, line.direction) <= double(w[3]) * w[3];
    if (kind == VOLUME_ELLIPSOID) {
        const auto mapped = [&](Vector v) {
            return Vector(glm::dot(stored(volume, 3), v), glm::dot(stored(volume, 6), v), glm::dot(stored(volume, 9), v));
        };
        return squared_distance(mapped(f), mapped(line.direction)) <= 1;
    }
    if (kind == VOLUME_ORIENTED_BOX) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Vector n = stored(volume, 3 + 3 * axis);
            stretch.cut(-w[12 + axis], w[12 + axis], glm::dot(f, n), glm::dot(line.direction, n));
        }
    } else if (kind == VOLUME_DIAGONALS) {
        for (std::size_t i = 0; i < diagonals.size(); ++i)
            stretch.cut(w[2 * i], w[2 * i + 1], glm::dot(line.origin, diagonals[i]), glm::dot(line.direction, diagonals[i]));
    }
    return stretch.exists();
}

constexpr uint lines_per_box = 64;

/// Radical inverse, for numbers that fill the unit interval evenly (van der Corput 1935).
double radical_inverse(uint i, uint base) {
    double result = 0, digit = 1.0 / base;
    for (; i > 0; i /= base, digit /= base) result += digit * (i % base);
    return result;
}

/// What line i of every box is made of: numbers from 0 to 1, but for the two of a direction across the side where it enters.
struct LineNumbers {
    double side, u, v, cosine, across_b, across_c;
    bool upper;
};

/// Uniform lines through a convex body enter it evenly over its surface, at cosine-distributed angles (Santaló, Integral Geometry, 1976).
std::array<LineNumbers, lines_per_box> make_line_numbers() {
    std::array<LineNumbers, lines_per_box> numbers;
    for (uint i = 0; i < lines_per_box; ++i) {
        const double angle = 2 * M_PI * radical_inverse(i, 3), sine_squared = radical_inverse(i, 5), sine = std::sqrt(sine_squared);
        numbers[i] = {(i + 0.5) / lines_per_box, radical_inverse(i, 7),  radical_inverse(i, 11),      std::sqrt(1 - sine_squared),
                      sine * std::cos(angle),    sine * std::sin(angle), radical_inverse(i, 2) >= 0.5};
    }
    return numbers;
}

Line line_into(const Bounds &box, const LineNumbers &numbers) {
    const Vector low(box.low), size = glm::max(Vector(box.high) - low, Vector(1e-30));
    const Vector areas(size.y * size.z, size.z * size.x, size.x * size.y);
    double choice = numbers.side * (areas.x + areas.y + areas.z);
    int axis = 0;
    while (axis < 2 && choice >= areas[axis]) choice -= areas[axis++];
    const int b = (axis + 1) % 3, c = (axis + 2) % 3;
    Line line;
    line.direction[axis] = numbers.upper ? -numbers.cosine : numbers.cosine;
    line.direction[b] = numbers.across_b, line.direction[c] = numbers.across_c;
    line.origin[axis] = low[axis] + (numbers.upper ? size[axis] : 0);
    line.origin[b] = low[b] + size[b] * numbers.u, line.origin[c] = low[c] + size[c] * numbers.v;
    return line;
}

}  // namespace

FittedVolumes fit_volumes(std::span<const HullPart> parts) {
    const Volume box = fit_oriented_box(parts);
    FittedVolumes volumes{};
    volumes[VOLUME_SPHERE] = fit_sphere(parts), volumes[VOLUME_ELLIPSOID] = fit_ellipsoid(parts, box);
    volumes[VOLUME_ORIENTED_BOX] = box, volumes[VOLUME_DIAGONALS] = fit_diagonals(parts);
    return volumes;
}

double part_of_lines(uint kind, const Volume &volume, const Bounds &box) {
    static const std::array<LineNumbers, lines_per_box> all = make_line_numbers();
    uint met = 0;
    for (const LineNumbers &numbers : all) {
        const Line line = line_into(box, numbers);
        Stretch stretch;
        for (int axis = 0; axis < 3; ++axis) stretch.cut(box.low[axis], box.high[axis], line.origin[axis], line.direction[axis]);
        met += meets(kind, volume, line, stretch);
    }
    return double(met) / lines_per_box;
}

}  // namespace brandung
