/// What light does, in long double: host code that shares nothing with the kernels.
#pragma once
#include <optional>

#include "scene/scene.h"

namespace oracle {

using Real = long double;
using Vec = glm::vec<3, Real>;

inline constexpr Real pi = 3.14159265358979323846264338327950288L;

struct Line {
    Vec origin, direction;  ///< unit length
    Vec at(Real t) const { return origin + t * direction; }
};

/// Through the middle of pixel (x, y) of the scene's first camera, or through (x / (width - 1), y / (height - 1)) for pixel `corner`.
Line eye_ray(const brandung::Scene &scene, uint x, uint y);

/// The two crossings with a sphere, in order.
struct Crossings {
    Real first, second;
};
std::optional<Crossings> cross_sphere(const Line &line, const Vec &center, Real radius);
/// The crossing with the plane through `point`.
Real cross_plane(const Line &line, const Vec &point, const Vec &normal);

Vec reflect(const Vec &direction, const Vec &normal);
/// By Snell's law, `normal` on the side that `direction` comes from; `eta`: index there over that beyond. Nothing at total internal reflection.
std::optional<Vec> refract(const Vec &direction, const Vec &normal, Real eta);
/// Fresnel's reflectance (1823) of unpolarised light by the indices and cosines on both sides.
Real fresnel(Real cosine_1, Real cosine_2, Real eta_1, Real eta_2);
/// The same by the angle of incidence; 1 at total internal reflection. `eta`: index on this side over that beyond.
Real fresnel(Real cosine, Real eta);

}  // namespace oracle
