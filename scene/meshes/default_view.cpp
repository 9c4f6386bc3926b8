#include "scene/meshes/default_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "scene/lights/light.h"
#include "scene/meshes/mesh_parts.h"
#include "scene/meshes/opening.h"
#include "scene/vectors.h"

namespace brandung {
namespace {

using glm::dvec3;

constexpr double default_fov = 35, azimuth = 30, elevation = 20;  // [degrees]
constexpr double margin = 1.05;                                   ///< of a shell's distance
constexpr double largest_misplacement = 0.2;  ///< of the camera by the rounding to floats, as a part of its distance; beyond it is nowhere
constexpr double light_shift = 0.35;          ///< of the light, up and to the left, as a part of the camera's distance
constexpr double fill = 0.1;                  ///< ambient light for what others do not reach, as a part of what faces them
constexpr double weakest_light = 0.01;        ///< of meshes that need no headlight, as a part of that

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

/// The irradiance [W/m²] that the meshes give themselves: radiance times area of what shines, seen from as far as their sphere's radius.
double own_irradiance(const Scene &scene, const std::vector<MeshPart> &parts) {
    if (scene.integrator.light_samples == 0) return 0;
    double power = 0;
    for (const MeshPart &part : parts) {
        const double radiance = largest(scene.materials[part.material].record.emission);
        if (radiance > 0) for_each_triangle(part, [&](const auto &corners) { power += radiance * 0.5 * glm::length(area_vector(corners)); });
    }
    const double radius = power > 0 ? bounding_sphere(parts).radius : 1;
    return power / (radius * radius);
}

std::string vector_text(vec3 v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

/// As the native format has it.
std::string light_text(const Light &light) {
    PointLight view;
    std::memcpy(&view, light.words, sizeof view);
    return fmt::format(R"("lights": [{{"type": "point", "position": {}, "intensity": {}, "attenuation": {}}}], )", vector_text(view.position),
                       view.intensity.x, vector_text(view.attenuation));
}

/// A scene file beside the meshes' own that gives the same picture, but for other options.
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

Framing frame(const std::vector<MeshPart> &parts, const FilmSettings &film, const ViewChanges &changes) {
    CameraDescription camera;
    camera.name = "camera";
    camera.fov = changes.fov.value_or(float(glm::radians(default_fov)));
    camera.up = changes.up.value_or(camera.up);
    const BoundingSphere sphere = bounding_sphere(parts);
    const dvec3 up = camera.up == vec3(0) ? dvec3(0, 1, 0) : glm::normalize(dvec3(camera.up)), at = dvec3(changes.at.value_or(vec3(sphere.center)));
    const double tan_y = std::tan(0.5 * double(camera.fov)), tan_x = tan_y * film.width / film.height;
    const dvec3 into = opening(parts, sphere.center, up), way = into == dvec3(0) ? three_quarters(up) : into;
    const double to_sphere = (sphere.radius + glm::length(at - sphere.center)) / std::sin(std::atan(std::min(tan_x, tan_y)));
    const double distance = into == dvec3(0) ? to_sphere : distance_to_see(parts, at, way, up, tan_x, tan_y);
    camera.at = vec3(at);
    const vec3 from(at + distance * way);
    const bool misplaced = glm::length(dvec3(from) - at - distance * way) > largest_misplacement * distance;
    camera.from = changes.from.value_or(misplaced ? camera.at : from);
    return {camera, into != dvec3(0)};
}

Light headlight(const Framing &framing) {
    const CameraDescription &camera = framing.camera;
    const dvec3 from(camera.from), way = from - dvec3(camera.at), right = glm::normalize(glm::cross(dvec3(camera.up), way)),
                                   upward = glm::normalize(glm::cross(way, right));
    const dvec3 shift = framing.in_shell ? dvec3(0) : light_shift * glm::length(way) * (upward - right);
    return make_light(PointLight{.position = vec3(from + shift), .intensity = Spectrum(std::numbers::pi_v<float>), .attenuation = {1, 0, 0}});
}

void set_default_quality(Scene &scene) { scene.film.spp = mesh_spp, scene.integrator.light_samples = mesh_light_samples; }

void add_default_view(const std::vector<MeshPart> &parts, const ViewChanges &changes, Scene &scene) {
    const Framing framing = frame(parts, scene.film, changes);
    const CameraDescription &camera = framing.camera;
    scene.cameras.push_back(camera);
    scene.notes.push_back("camera: " + view_options(camera));
    scene.notes.push_back(fmt::format("samples: --spp {} --light-samples {}", scene.film.spp, scene.integrator.light_samples));
    if (parts.empty() || view_fault(camera)) return;
    double irradiance = own_irradiance(scene, parts);
    if (irradiance < weakest_light * std::numbers::pi) {
        scene.headlight = uint(scene.lights.size());
        scene.lights.push_back(headlight(framing));
        irradiance = std::numbers::pi;
    }
    scene.ambient = Spectrum(float(fill * irradiance / std::numbers::pi));
    scene.notes.push_back("scene: " + scene_text(scene));
}

}  // namespace brandung
