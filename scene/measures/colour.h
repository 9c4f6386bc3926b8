/// Colour spaces of perception, from linear Rec. 709.
#pragma once
#include "kernels/core/portable.h"

namespace brandung {

/// CIE Y; that of white (1, 1, 1) is 1.
double luminance(const glm::dvec3 &linear);
/// CIELAB relative to white.
glm::dvec3 lab(const glm::dvec3 &linear);
/// YyCxCz: lightness, red-green and blue-yellow, all linear in light (Zhang & Wandell 1997, in the form of Andersson et al. 2020).
glm::dvec3 opponent(const glm::dvec3 &linear);
/// The inverse.
glm::dvec3 from_opponent(const glm::dvec3 &yxz);

}  // namespace brandung
