/// Interfaces between media for the tests of kinds of glass.
#pragma once
#include <cmath>
#include <string>

#include "tests/kernels/bsdfs/probed_bsdf.h"

namespace brandung {

/// Of an object of a scene file, met with this index of refraction over that beyond.
inline ProbedBsdf probed(const std::string &text, double eta) { return ProbedBsdf({"", text.c_str(), 0, 0, float(eta)}); }

/// Above the surface, at this cosine.
inline vec3 direction(double cosine, double azimuth = 0) {
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    return vec3(float(sine * std::cos(azimuth)), float(sine * std::sin(azimuth)), float(cosine));
}

/// Fresnel's reflectance of unpolarised light by the angles (Born & Wolf, 1.5.2); 1 at total internal reflection.
inline double fresnel_by_angles(double cosine, double eta) {
    const double sine = eta * std::sqrt((1 - cosine) * (1 + cosine)), a = std::acos(cosine), b = std::asin(sine);
    if (sine >= 1) return 1;
    if (a < 1e-6) return std::pow((eta - 1) / (eta + 1), 2);
    return 0.5 * (std::pow(std::sin(a - b) / std::sin(a + b), 2) + std::pow(std::tan(a - b) / std::tan(a + b), 2));
}

}  // namespace brandung
