#include "scene/meshes/default_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "scene/bounds.h"
#include "scene/lights/light.h"
#include "scene/vectors.h"

namespace brandung {
namespace {

using glm::dvec3;

constexpr double default_fov = 35, azimuth = 30, elevation = 20;  // [degrees]
constexpr double margin = 1.05;                                   ///< of a shell's distance
constexpr double shell_share = 0.1;           ///< a shell is open if its vector area is at least this part of its area; a box without a side has 0.2
constexpr double wall_share = 0.7;            ///< of the half away from the opening that a shell covers; a room without ceiling covers 5/6
constexpr int probes = 100;                   ///< directions in which walls are looked for
constexpr double largest_misplacement = 0.2;  ///< of the camera by the rounding to floats, as a part of its distance; beyond it is nowhere
constexpr double light_shift = 0.35;          ///< of the light, up and to the left, as a part of the camera's distance
constexpr double nearly_straight = 20;        // [degrees]
constexpr double fill = 0.1;                  ///< ambient light for what others do not reach, as a part of what faces them
constexpr double weakest_light = 0.01;        ///< of meshes that need no headlight, as a part of that
constexpr uint default_spp = 16, default_light_samples = 2;

template <class Visit> void for_each_vertex(const std::vector<MeshPart> &parts, const Visit &visit) {
    for (const MeshPart &part : parts)
        for (const uint index : part.mesh.indices) visit(dvec3(part.mesh.positions[index]));
}

struct Sphere {
    dvec3 center;
    double radius;
};

/// Around the centre of the meshes' box.
Sphere bounding_sphere(const std::vector<MeshPart> &parts) {
    Bounds bounds;
    for_each_vertex(parts, [&](const dvec3 &p) { bounds.add(vec3(p)); });
    if (bounds.empty()) return {dvec3(0), 1};
    Sphere sphere{0.5 * (dvec3(bounds.low) + dvec3(bounds.high)), 0};
    for_each_vertex(parts, [&](const dvec3 &p) { sphere.radius = std::max(sphere.radius, glm::length(p - sphere.center)); });
    return sphere;
}

/// The vector area as a part of the area: 0 for closed surfaces, 1 for a flat one.
dvec3 mean_normal(const std::vector<MeshPart> &parts) {
    dvec3 vector(0);
    double area = 0;
    for (const MeshPart &part : parts) {
        const auto &[positions, indices] = std::tie(part.mesh.positions, part.mesh.indices);
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            const dvec3 a(positions[indices[i]]), n = glm::cross(dvec3(positions[indices[i + 1]]) - a, dvec3(positions[indices[i + 2]]) - a);
            vector += n, area += glm::length(n);
        }
    }
    return area > 0 ? vector / area : dvec3(0);
}

/// Whether a ray meets a triangle (Möller and Trumbore 1997).
bool meets(const dvec3 &from, const dvec3 &way, const dvec3 &a, const dvec3 &b, const dvec3 &c) {
    const dvec3 p = glm::cross(way, c - a), q = glm::cross(from - a, b - a);
    const double determinant = glm::dot(b - a, p), u = glm::dot(from - a, p) / determinant, v = glm::dot(way, q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && glm::dot(c - a, q) / determinant > 0;  // false of what is not finite
}

/// Directions that are spread evenly over the half of the sphere around `axis`: points of a spiral (Swinbank and Purser 2006).
std::vector<dvec3> half_sphere(const dvec3 &axis) {
    const dvec3 side = glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0))), other = glm::cross(axis, side);
    std::vector<dvec3> directions;
    for (int i = 0; i < probes; ++i) {
        const double height = (i + 0.5) / probes, radius = std::sqrt(1 - height * height), turn = 2 * std::numbers::pi * i / std::numbers::phi;
        directions.push_back(height * axis + radius * (std::cos(turn) * side + std::sin(turn) * other));
    }
    return directions;
}

/// Whether most of what is seen from the middle, away from the opening, is the meshes: a room has walls, a floor with things on it does not.
bool encloses(const std::vector<MeshPart> &parts, const dvec3 &middle, const dvec3 &opening) {
    std::vector<dvec3> free = half_sphere(-opening);
    for (const MeshPart &part : parts) {
        const auto &[positions, indices] = std::tie(part.mesh.positions, part.mesh.indices);
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            const dvec3 a(positions[indices[i]]), b(positions[indices[i + 1]]), c(positions[indices[i + 2]]);
            std::erase_if(free, [&](const dvec3 &way) { return meets(middle, way, a, b, c); });
        }
    }
    return double(free.size()) <= (1 - wall_share) * probes;
}

/// The horizontal direction into which an open shell faces; 0 if there is none. Rooms are looked into along an axis.
dvec3 opening(const std::vector<MeshPart> &parts, const dvec3 &up) {
    const dvec3 mean = mean_normal(parts), horizontal = mean - up * glm::dot(mean, up);
    if (glm::length(horizontal) < shell_share) return dvec3(0);
    const dvec3 direction = glm::normalize(horizontal);
    if (!encloses(parts, bounding_sphere(parts).center, direction)) return dvec3(0);
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 along(0);
        along[axis] = std::copysign(1.0, direction[axis]);
        if (std::abs(direction[axis]) > std::cos(glm::radians(nearly_straight)) && std::abs(glm::dot(along, up)) < 1e-6) return along;
    }
    return direction;
}

/// Towards the eye, of unit length.
dvec3 three_quarters(const dvec3 &up) {
    const dvec3 axis = std::abs(up.z) < 0.9 ? dvec3(0, 0, 1) : dvec3(0, -1, 0);
    const dvec3 front = glm::normalize(axis - up * glm::dot(axis, up)), right = glm::cross(up, front);
    const double a = glm::radians(azimuth), e = glm::radians(elevation);
    return std::cos(e) * (std::cos(a) * front + std::sin(a) * right) + std::sin(e) * up;
}

/// From `at` so far in the direction `way` that all vertices are seen.
double distance_to_see(const std::vector<MeshPart> &parts, const dvec3 &at, const dvec3 &way, const dvec3 &up, double tan_x, double tan_y) {
    const dvec3 right = glm::normalize(glm::cross(up, way)), upward = glm::cross(way, right);
    double distance = 0;
    for_each_vertex(parts, [&](const dvec3 &p) {
        const dvec3 q = p - at;
        distance = std::max(distance, glm::dot(q, way) + std::max(std::abs(glm::dot(q, right)) / tan_x, std::abs(glm::dot(q, upward)) / tan_y));
    });
    return margin * distance;
}

double area_of(const MeshData &mesh) {
    double area = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        area += 0.5 * glm::length(
                          area_vector({{mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]], mesh.positions[mesh.indices[i + 2]]}}));
    return area;
}

/// The irradiance [W/m²] that the meshes give themselves: radiance times area of what shines, seen from as far as the meshes' sphere is wide.
double own_irradiance(const Scene &scene, const std::vector<MeshPart> &parts) {
    const double radius = bounding_sphere(parts).radius;
    double power = 0;
    for (const MeshPart &part : parts) power += largest(scene.materials[part.material].record.emission) * area_of(part.mesh);
    return scene.integrator.light_samples == 0 || power == 0 ? 0 : power / (radius * radius);
}

std::string vector_text(vec3 v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

/// As the native format has it.
std::string light_text(const Light &light) {
    PointLight view;
    std::memcpy(&view, light.words, sizeof view);
    return fmt::format(R"("lights": [{{"type": "point", "position": {}, "intensity": {}, "attenuation": {}}}], )", vector_text(view.position),
                       view.intensity.x, vector_text(view.attenuation));
}

/// A scene file beside the meshes' own that gives the same picture.
std::string scene_text(const Scene &scene) {
    const CameraDescription &camera = scene.cameras[0];
    const std::string file = std::filesystem::path(scene.file).filename().string();
    return fmt::format(R"({{"film": {{"width": {}, "height": {}, "spp": {}}}, "integrator": {{"light_samples": {}}}, )", scene.film.width,
                       scene.film.height, scene.film.spp, scene.integrator.light_samples) +
           fmt::format(R"("camera": {{"from": {}, "at": {}, "up": {}, "fov": {:.7g}}}, )", vector_text(camera.from), vector_text(camera.at),
                       vector_text(camera.up), glm::degrees(camera.fov)) +
           (scene.lights.empty() ? "" : light_text(scene.lights[0])) +
           fmt::format(R"("ambient": {}, "objects": [{{"type": "mesh", "file": {}}}]}})", scene.ambient.x,
                       nlohmann::json(file).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace

CameraDescription framing_camera(const std::vector<MeshPart> &parts, const FilmSettings &film, const ViewChanges &changes) {
    CameraDescription camera;
    camera.name = "camera";
    camera.fov = changes.fov.value_or(float(glm::radians(default_fov)));
    camera.up = changes.up.value_or(camera.up);
    const Sphere sphere = bounding_sphere(parts);
    const dvec3 up = camera.up == vec3(0) ? dvec3(0, 1, 0) : glm::normalize(dvec3(camera.up)), at = dvec3(changes.at.value_or(vec3(sphere.center)));
    const double tan_y = std::tan(0.5 * double(camera.fov)), tan_x = tan_y * film.width / film.height;
    const dvec3 into = opening(parts, up), way = into == dvec3(0) ? three_quarters(up) : into;
    const double to_sphere = (sphere.radius + glm::length(at - sphere.center)) / std::sin(std::atan(std::min(tan_x, tan_y)));
    const double distance = into == dvec3(0) ? to_sphere : distance_to_see(parts, at, way, up, tan_x, tan_y);
    camera.at = vec3(at);
    const vec3 from(at + distance * way);
    const bool misplaced = glm::length(dvec3(from) - at - distance * way) > largest_misplacement * distance;
    camera.from = changes.from.value_or(misplaced ? camera.at : from);
    return camera;
}

Light headlight(const std::vector<MeshPart> &parts, const CameraDescription &camera) {
    const dvec3 from(camera.from), way = from - dvec3(camera.at), right = glm::normalize(glm::cross(dvec3(camera.up), way)),
                                   upward = glm::normalize(glm::cross(way, right));
    const bool in_shell = opening(parts, glm::normalize(dvec3(camera.up))) != dvec3(0);
    const dvec3 shift = in_shell ? dvec3(0) : light_shift * glm::length(way) * (upward - right);
    return make_light(PointLight{.position = vec3(from + shift), .intensity = Spectrum(std::numbers::pi_v<float>), .attenuation = {1, 0, 0}});
}

void set_default_quality(Scene &scene) { scene.film.spp = default_spp, scene.integrator.light_samples = default_light_samples; }

void add_default_view(const std::vector<MeshPart> &parts, const ViewChanges &changes, Scene &scene) {
    const CameraDescription camera = framing_camera(parts, scene.film, changes);
    scene.cameras.push_back(camera);
    scene.notes.push_back("camera: " + view_options(camera));
    scene.notes.push_back(fmt::format("samples: --spp {} --light-samples {}", scene.film.spp, scene.integrator.light_samples));
    if (parts.empty() || view_fault(camera)) return;
    double irradiance = own_irradiance(scene, parts);
    if (irradiance < weakest_light * std::numbers::pi) {
        scene.headlight = uint(scene.lights.size());
        scene.lights.push_back(headlight(parts, camera));
        irradiance = std::numbers::pi;
    }
    scene.ambient = Spectrum(float(fill * irradiance / std::numbers::pi));
    scene.notes.push_back("scene: " + scene_text(scene));
}

}  // namespace brandung
