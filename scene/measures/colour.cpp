#include "scene/measures/colour.h"

#include <cmath>

namespace brandung {
namespace {

/// XYZ of chromaticities x and y at Y = 1.
glm::dvec3 at_unit_luminance(double x, double y) { return {x / y, 1, (1 - x - y) / y}; }

/// Linear Rec. 709 to XYZ, from the chromaticities of its primaries and those of D65, to as many digits as the authors of FLIP take.
glm::dmat3 rgb_to_xyz() {
    const glm::dmat3 primaries(at_unit_luminance(0.64, 0.33), at_unit_luminance(0.30, 0.60), at_unit_luminance(0.15, 0.06));
    const glm::dvec3 amounts = glm::inverse(primaries) * at_unit_luminance(0.31271, 0.32902);
    return {primaries[0] * amounts[0], primaries[1] * amounts[1], primaries[2] * amounts[2]};
}

const glm::dmat3 to_xyz = rgb_to_xyz(), from_xyz = glm::inverse(to_xyz);
const glm::dvec3 white = to_xyz * glm::dvec3(1);

/// CIE 15: the cube root, straight near black.
double lightness_curve(double t) {
    constexpr double delta = 6.0 / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

}  // namespace

double luminance(const glm::dvec3 &linear) { return (to_xyz * linear).y; }

glm::dvec3 lab(const glm::dvec3 &linear) {
    const glm::dvec3 t = to_xyz * linear / white;
    const double x = lightness_curve(t.x), y = lightness_curve(t.y), z = lightness_curve(t.z);
    return glm::dvec3(116 * y - 16, 500 * (x - y), 200 * (y - z));
}

glm::dvec3 opponent(const glm::dvec3 &linear) {
    const glm::dvec3 t = to_xyz * linear / white;
    return glm::dvec3(116 * t.y - 16, 500 * (t.x - t.y), 200 * (t.y - t.z));
}

glm::dvec3 from_opponent(const glm::dvec3 &yxz) {
    const double y = (yxz.x + 16) / 116;
    return from_xyz * (white * glm::dvec3(y + yxz.y / 500, y, y - yxz.z / 200));
}

}  // namespace brandung
