#include "tools/bench/growing_scenes.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "tools/bench/random_places.h"

namespace brandung {
namespace {

constexpr double volume_of_spheres = 0.02;
constexpr double cluster_width = 0.01;

/// Of each of so many spheres that have that part of the cube's volume.
float radius_of(uint spheres) { return static_cast<float>(std::cbrt(volume_of_spheres * 3 / (4 * std::numbers::pi * spheres))); }

void add_spheres(Scene &scene, uint count, float radius, vec3 corner, float width, RandomPlaces &random) {
    for (uint i = 0; i < count; ++i) scene.shapes.push_back(make_sphere(0, corner + width * random.in_cube(), radius));
}

void add_clumped(Scene &scene, uint objects, RandomPlaces &random) {
    const float radius = radius_of(objects), width = static_cast<float>(cluster_width);
    add_spheres(scene, objects / 2, radius * width, vec3(0.5f - 0.5f * width), width, random);
    add_spheres(scene, objects - objects / 2, radius, vec3(0), 1, random);
}

/// Equilateral, about its centre.
void add_triangle(MeshData &mesh, float edge, RandomPlaces &random) {
    const vec3 centre = random.in_cube(), along = random.direction();
    vec3 across = glm::cross(along, random.direction());
    while (glm::dot(across, across) < 0.01f) across = glm::cross(along, random.direction());
    across = glm::normalize(across);
    for (int corner = 0; corner < 3; ++corner) {
        const double turn = corner * 2 * std::numbers::pi / 3;
        const vec3 from_centre = static_cast<float>(std::cos(turn)) * along + static_cast<float>(std::sin(turn)) * across;
        mesh.indices.push_back(static_cast<uint>(mesh.positions.size()));
        mesh.positions.push_back(centre + edge / std::sqrt(3.0f) * from_centre);
    }
}

void add_triangles(Scene &scene, uint objects, RandomPlaces &random) {
    MeshData mesh;
    const auto edge = static_cast<float>(0.5 / std::cbrt(double(objects)));
    for (uint i = 0; i < objects; ++i) add_triangle(mesh, edge, random);
    scene.shapes.push_back(make_triangle_mesh(0, std::move(mesh)));
}

}  // namespace

Scene growing_scene(const std::string &kind, uint objects) {
    Scene scene;
    scene.file = kind;
    scene.materials.push_back({"matte", Material{}});
    RandomPlaces random(1);
    if (kind == "triangles") {
        add_triangles(scene, objects, random);
    } else if (kind == "clumped") {
        add_clumped(scene, objects, random);
    } else {
        add_spheres(scene, objects, radius_of(objects), vec3(0), 1, random);
    }
    return scene;
}

std::vector<RayQueue> rays_in_cube(std::size_t count) {
    RayQueue closest{RayQueue::Use::random, false, false, {}, std::vector<uint>(count)}, shadows = closest;
    shadows.shadow = true;
    RandomPlaces random(2);
    for (std::size_t i = 0; i < count; ++i) {
        const vec3 origin = random.in_cube();
        const uint closest_tag = RAY_TAG(RAY_CAMERA, NO_HIT), shadow_tag = RAY_TAG(RAY_SHADOW, NO_HIT);
        closest.rays.push_back(
            {.origin = origin, .t_max = std::numeric_limits<float>::infinity(), .direction = random.direction(), .tag = closest_tag});
        const vec3 way = random.in_cube() - origin;
        const float length = glm::length(way);
        shadows.rays.push_back({.origin = origin, .t_max = length, .direction = way / length, .tag = shadow_tag});
    }
    return {std::move(closest), std::move(shadows)};
}

}  // namespace brandung
