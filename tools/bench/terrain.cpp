#include "tools/bench/terrain.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "scene/primitives/add.h"
#include "tools/bench/random_places.h"

namespace brandung {
namespace {

constexpr double width = 100, turn = 2 * std::numbers::pi;
constexpr uint octaves = 9;

/// Sums of waves of which each has about half the length and height of the one before.
double height(double x, double z) {
    double sum = 0, amplitude = 5, frequency = 0.09;
    for (uint octave = 0; octave < octaves; ++octave) {
        sum += amplitude * std::sin(frequency * x + 1.3 * octave) * std::cos(frequency * z - 0.7 * octave);
        const double along = 0.8 * x - 0.6 * z;  // turned, so that no two octaves have the same axes
        z = 0.6 * x + 0.8 * z, x = along;
        amplitude *= 0.47, frequency *= 2.03;
    }
    return sum;
}

/// Leans over, so that some of it hides behind itself.
glm::dvec3 ground(double u, double v) {
    const double x = width * (u - 0.5), z = width * (v - 0.5);
    return {x + 1.5 * std::sin(0.31 * z) + 0.3 * std::sin(1.7 * x), height(x, z), z + 1.5 * std::sin(0.27 * x) + 0.3 * std::cos(1.9 * z)};
}

/// So many cells along each axis of points (u, v) in [0, 1]², two triangles each.
template <class Surface> void add_grid(MeshData &mesh, uint columns, uint rows, Surface surface) {
    const uint first = static_cast<uint>(mesh.positions.size());
    for (uint y = 0; y <= rows; ++y)
        for (uint x = 0; x <= columns; ++x) mesh.positions.push_back(vec3(surface(double(x) / columns, double(y) / rows)));
    for (uint y = 0; y < rows; ++y)
        for (uint x = 0; x < columns; ++x) {
            const uint a = first + y * (columns + 1) + x, b = a + 1, c = a + columns + 1, d = c + 1;
            mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, d});
        }
}

glm::dvec3 lumpy_sphere(double u, double v) {
    const double longitude = turn * u, latitude = std::numbers::pi * v;
    const double radius = 1 + 0.15 * std::sin(5 * longitude) * std::sin(7 * latitude) * std::sin(latitude);
    return radius * glm::dvec3(std::sin(latitude) * std::cos(longitude), std::cos(latitude), std::sin(latitude) * std::sin(longitude));
}

/// The curve that winds twice around its axis and three times through its hole.
glm::dvec3 knot_curve(double u) {
    const double around = turn * 2 * u, through = turn * 3 * u, radius = 0.7 + 0.25 * std::cos(through);
    return {radius * std::cos(around), 0.25 * std::sin(through), radius * std::sin(around)};
}

glm::dvec3 knot(double u, double v) {
    const glm::dvec3 centre = knot_curve(u), along = glm::normalize(knot_curve(u + 1e-4) - knot_curve(u - 1e-4));
    const glm::dvec3 across = glm::normalize(glm::cross(along, glm::dvec3(0, 1, 0))), up = glm::cross(across, along);
    return centre + 0.12 * (std::cos(turn * v) * across + std::sin(turn * v) * up);
}

/// Together they cover the terrain about once, however many they are.
void add_objects(MeshData &mesh, uint triangles, RandomPlaces &random) {
    const uint objects = static_cast<uint>(std::sqrt(triangles / 4.0)), cells = triangles / objects / 2;
    const uint rows = static_cast<uint>(std::sqrt(cells / 2.0)), columns = cells / rows;
    for (uint i = 0; i < objects; ++i) {
        const double size = width / std::sqrt(double(objects)) * (0.3 + 0.4 * double(random.unit()));
        const double u = double(random.unit()), v = double(random.unit()), turned = turn * double(random.unit());
        const glm::dvec3 place = ground(u, v) + glm::dvec3(0, size * (0.5 + 2 * double(random.unit())), 0);
        const auto placed = [&](glm::dvec3 p) {
            const glm::dvec3 q = {std::cos(turned) * p.x - std::sin(turned) * p.y, std::sin(turned) * p.x + std::cos(turned) * p.y, p.z};
            return place + size * q;
        };
        if (i % 2 == 0)
            add_grid(mesh, columns, rows, [&](double a, double b) { return placed(lumpy_sphere(a, b)); });
        else
            add_grid(mesh, columns, rows, [&](double a, double b) { return placed(knot(a, b)); });
    }
}

}  // namespace

Scene terrain(uint triangles) {
    Scene scene;
    scene.file = fmt::format("terrain:{}", triangles);
    scene.cameras.push_back({.name = "camera", .from = {-46, 16, -46}, .at = {0, -2, 0}});
    scene.materials.push_back({"matte", Material{}});
    MeshData mesh;
    RandomPlaces random(1);
    const uint side = static_cast<uint>(std::sqrt(triangles / 4.0));
    add_grid(mesh, side, side, ground);
    add_objects(mesh, triangles - 2 * side * side, random);
    add_triangle_mesh(scene, 0, std::move(mesh));
    return scene;
}

}  // namespace brandung
