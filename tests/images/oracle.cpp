#include "tests/images/oracle.h"

#include <cmath>

namespace oracle {

Line eye_ray(const brandung::Scene &scene, uint x, uint y) {
    const brandung::CameraDescription &camera = scene.cameras.at(0);
    const Real width = scene.film.width, height = scene.film.height;
    const bool corner = scene.film.pixel == PIXEL_CORNER;
    const Real across = corner ? x / (width - 1) : (x + 0.5L) / width, down = corner ? y / (height - 1) : (y + 0.5L) / height;
    const Vec forward = glm::normalize(Vec(camera.at) - Vec(camera.from));
    const Vec right = glm::normalize(glm::cross(forward, Vec(camera.up))), up = glm::cross(right, forward);
    const Real half_height = std::tan(Real(camera.fov) / 2), half_width = half_height * width / height;
    return {Vec(camera.from), glm::normalize(forward + (2 * across - 1) * half_width * right + (1 - 2 * down) * half_height * up)};
}

std::optional<Crossings> cross_sphere(const Line &line, const Vec &center, Real radius) {
    const Vec f = line.origin - center;
    const Real middle = -glm::dot(f, line.direction), discriminant = middle * middle - glm::dot(f, f) + radius * radius;
    if (discriminant < 0) return {};
    return Crossings{middle - std::sqrt(discriminant), middle + std::sqrt(discriminant)};
}

Real cross_plane(const Line &line, const Vec &point, const Vec &normal) {
    return glm::dot(point - line.origin, normal) / glm::dot(line.direction, normal);
}

Vec reflect(const Vec &direction, const Vec &normal) { return direction - 2 * glm::dot(direction, normal) * normal; }

std::optional<Vec> refract(const Vec &direction, const Vec &normal, Real eta) {
    const Vec tangent = eta * (direction - glm::dot(direction, normal) * normal);  // sines
    const Real sine_squared = glm::dot(tangent, tangent);
    if (sine_squared > 1) return {};
    return tangent - std::sqrt(1 - sine_squared) * normal;
}

Real fresnel(Real cosine_1, Real cosine_2, Real eta_1, Real eta_2) {
    const Real c = cosine_1 * cosine_2, n = eta_1 * eta_2;
    const Real a = eta_1 * eta_1 - eta_2 * eta_2, b = cosine_1 * cosine_1 - cosine_2 * cosine_2;
    const Real below = c * (eta_1 * eta_1 + eta_2 * eta_2) + n * (cosine_1 * cosine_1 + cosine_2 * cosine_2);
    return (a * a * c * c + b * b * n * n) / (below * below);
}

Real fresnel(Real cosine, Real eta) {
    const Real sine_squared = eta * eta * (1 - cosine) * (1 + cosine);
    return sine_squared >= 1 ? 1 : fresnel(cosine, std::sqrt(1 - sine_squared), eta, 1);
}

}  // namespace oracle
