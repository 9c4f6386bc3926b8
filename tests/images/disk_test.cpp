/// Disks look, shade and shine as what they are cut into does.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "scene/primitives/add.h"
#include "scene/vectors.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

/// A fan of triangles whose corners are on the rim.
void add_fan(Scene &scene, uint material, vec3 center, vec3 normal, float radius, uint corners) {
    const glm::dvec3 n = glm::normalize(glm::dvec3(normal)), x = glm::normalize(glm::cross(n, glm::dvec3(0.36, 0.48, 0.8))), y = glm::cross(n, x);
    MeshData mesh{.positions = {center}};
    for (uint i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        mesh.positions.push_back(vec3(glm::dvec3(center) + double(radius) * (std::cos(angle) * x + std::sin(angle) * y)));
        for (const uint corner : {0u, i + 1, (i + 1) % corners + 1}) mesh.indices.push_back(corner);
    }
    add_triangle_mesh(scene, material, std::move(mesh));
}

using AddDisk = void (*)(Scene &scene, uint material, vec3 center, vec3 normal, float radius);
void add_as_mesh(Scene &scene, uint material, vec3 center, vec3 normal, float radius) { add_fan(scene, material, center, normal, radius, 1024); }

/// Matte, mirroring and glass disks under lamps, one of which is a disk; one is in an instance.
Scene scene_of_disks(AddDisk add) {
    Scene scene = empty_scene();
    scene.cameras = {{.name = "camera", .from = {0.3f, 1.5f, 5}, .at = {0, 0.4f, 0}, .fov = 0.7f}};
    scene.film.width = 160, scene.film.height = 120;
    scene.ambient = Spectrum(0.1f), scene.background = Spectrum(0.3f, 0.4f, 0.5f);
    scene.lights.push_back(point_light({2, 4, 3}, Spectrum(30)));
    add_triangle(scene, 0, {-9, 0, 5}, {9, 0, 5}, {0, 0, -15});
    add(scene, add_material(scene, matte(0.8f)), {-1.2f, 0.7f, 0}, {0.4f, 0.1f, 1}, 0.6f);
    add(scene, add_material(scene, mirror(0.8f)), {0.3f, 0.7f, -0.8f}, {-0.3f, 0, 1}, 0.7f);
    add(scene, add_material(scene, glass(1)), {0.9f, 0.5f, 0.6f}, {0, 0.3f, -1}, 0.4f);
    std::vector<std::unique_ptr<Shape>> world = std::exchange(scene.shapes, {});
    add(scene, add_material(scene, matte(0.3f)), {0, 0, 0}, {0, 1, 0}, 1);
    const uint group = add_group(scene, "disk", std::exchange(scene.shapes, std::move(world)));
    EXPECT_FALSE(add_instance(scene, group, then(scaling({0.5, 1, -0.2}), then(rotation(50, {1, 1, 0}), translation({1.4, 0.8, -0.5})))));
    return scene;
}

}  // namespace

/// But for pixels whose ray passes between the rim and an edge of the fan, at most 5e-6 of the radius wide.
TEST(Disk, LooksAsAMeshOfManyCorners) {
    const Rendering exact = render_scene(scene_of_disks(add_disk)), cut = render_scene(scene_of_disks(add_as_mesh));
    EXPECT_EQ(exact.refused, 0u);
    std::size_t off = 0;
    for (std::size_t i = 0; i < exact.picture.size(); ++i) off += largest(glm::abs(exact.picture[i] - cut.picture[i])) > 1e-4f;
    EXPECT_LE(off, 2u);
    EXPECT_GT(exact.counts.rays[RAY_REFLECTED], 500u);
    EXPECT_GT(exact.counts.rays[RAY_REFRACTED], 300u);
    const Rendering coarse = render_scene(scene_of_disks(
        [](Scene &scene, uint material, vec3 center, vec3 normal, float radius) { add_fan(scene, material, center, normal, radius, 24); }));
    std::size_t seen = 0;
    for (std::size_t i = 0; i < exact.picture.size(); ++i) seen += largest(glm::abs(exact.picture[i] - coarse.picture[i])) > 1e-4f;
    EXPECT_GT(seen, 20u) << "the test can tell";
}

/// Under a disk that shines.
TEST(Disk, HasTheSameBitsForEveryAcceleratorAndBatch) {
    Scene scene = scene_of_disks(add_disk);
    scene.integrator.type = "path";
    add_disk(scene, add_material(scene, emitter(Spectrum(5))), {-0.5f, 2, 1}, {0, -1, -0.3f}, 0.5f);
    expect_same_bits(scene);
}

}  // namespace brandung
