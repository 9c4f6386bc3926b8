/// kernels/lights/emissive_*.cl: points of shapes that shine lie where their densities say.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/support/probe.h"
#include "tests/support/scenes.h"
#include "tests/support/statistics/chi_square.h"
#include "tests/support/statistics/significance.h"
#include "tests/support/traced_scene.h"

namespace brandung {
namespace {

constexpr uint count = 1 << 17;

/// Directions times distances from `p` to points of the only lamp, for rays of so many branches.
std::vector<vec3> ways_to_lamp(Scene &scene, vec3 p) {
    const CompiledScene compiled = compile(scene);
    const DeviceScene on_device(test_device(), compiled);
    Sources sources = on_device.lists();
    sources["ways.cl"] = R"(#include "kernels/core/random.cl"
#include "kernels/core/scene.cl"
#include "kernels/lights/light.cl"
        kernel void ways(SCENE_PARAMS, float x, float y, float z, uint rows, global vec3 *ways) {
            const Scene scene = SCENE;
            const uint i = get_global_id(0);
            const LightSample sample = light_sample(scene, SCENE_ARRAY(scene, Light, lights)[i % rows], make3(x, y, z), hash(i), PLACEMENT(0u, 0.0f));
            ways[i] = scaled(sample.ray_direction, sample.distance);
        })";
    Kernel kernel(test_device(), "ways.cl", "ways", sources, 1);
    const Buffer<vec3> ways(test_device(), kernel.work_items(count));
    kernel(count, on_device, p.x, p.y, p.z, compiled.header.lights.count, ways);
    return ways.read(0, count);
}

Scene scene_with_lamp() {
    Scene scene = empty_scene();
    add_sphere(scene, 0, {100, 0, 0}, 1);  // without anything to light there are no lights
    add_material(scene, emitter(Spectrum(1)));
    return scene;
}

/// Counts in cells of the unit square onto which `place` maps the lamp's points.
std::vector<std::uint64_t> counts_in_square(const std::vector<vec3> &ways, vec3 p, std::size_t cells, const std::function<vec2(vec3)> &place) {
    std::vector<std::uint64_t> counts(cells * cells);
    const auto cell = [&](float x) { return std::min(std::size_t(std::max(x, 0.0f) * float(cells)), cells - 1); };
    for (const vec3 &way : ways) {
        const vec2 at = place(p + way);
        ++counts[cell(at.x) * cells + cell(at.y)];
    }
    return counts;
}

/// Angle about the y axis, from 0 to 1.
float turn_of(vec3 q) { return float(std::atan2(double(q.z), double(q.x)) / (2 * M_PI) + 0.5); }

void expect_uniform(const std::vector<std::uint64_t> &counts) {
    EXPECT_TRUE(statistics::plausible(statistics::chi_square(counts, std::vector<double>(counts.size(), 1)).p));
}

class EmissiveShape : public testing::TestWithParam<uint> {};

}  // namespace

/// Seen from p = (0, d, 0), z² of the points, z along y, is uniform from (r / d)² to 1.
TEST_P(EmissiveShape, SpheresShowThePartThatFacesAPointAsTheirDensitySays) {
    Scene scene = scene_with_lamp();
    scene.integrator.light_samples = GetParam();
    add_sphere(scene, 1, {0, 0, 0}, 2);
    const vec3 outside(0, 3, 0);
    expect_uniform(counts_in_square(ways_to_lamp(scene, outside), outside, 16, [](vec3 q) {
        const float z = q.y / 2;
        return vec2((z * z - 4.0f / 9) / (5.0f / 9), turn_of(q));
    }));
    // From inside, by Archimedes, z is uniform.
    const vec3 inside(0, 1, 0);
    expect_uniform(counts_in_square(ways_to_lamp(scene, inside), inside, 16, [](vec3 q) { return vec2((q.y / 2 + 1) / 2, turn_of(q)); }));
}

/// So near that nearly all points have z = 1 in floats: uniform is the squared sine, from 0 to 1 - (r / d)².
TEST_P(EmissiveShape, LargeSpheresShowTheirDensityToPointsCloseToThem) {
    Scene scene = scene_with_lamp();
    scene.integrator.light_samples = GetParam();
    add_sphere(scene, 1, {0, 0, 0}, 1000);
    const vec3 p(0, 1000.001f, 0);
    const double d = p.y, seen = 1 - 1e6 / (d * d);
    expect_uniform(counts_in_square(ways_to_lamp(scene, p), p, 16,
                                    [&](vec3 q) { return vec2((double(q.x) * q.x + double(q.z) * q.z) / (1e6 * seen), turn_of(q)); }));
}

/// Of a cone from radius 2 to 1/2: the squared radius is uniform.
TEST_P(EmissiveShape, ConesShineUniformlyByArea) {
    Scene scene = scene_with_lamp();
    scene.integrator.light_samples = GetParam();
    add_frustum(scene, 1, {0, 0, 0}, 2, {0, 3, 0}, 0.5f);
    const vec3 p(7, 1, 2);
    expect_uniform(counts_in_square(ways_to_lamp(scene, p), p, 16, [](vec3 q) {
        const float radius = 2 - 0.5f * q.y;
        return vec2((radius * radius - 0.25f) / 3.75f, turn_of(q));
    }));
}

/// Around the middle of a disk the squared radius is uniform.
TEST_P(EmissiveShape, DisksShineUniformlyByArea) {
    Scene scene = scene_with_lamp();
    scene.integrator.light_samples = GetParam();
    add_disk(scene, 1, {0, 2, 0}, {0, -1, 0}, 1.5f);
    const vec3 p(0.5f, 0, 0.2f);
    expect_uniform(counts_in_square(ways_to_lamp(scene, p), p, 16, [](vec3 q) { return vec2((q.x * q.x + q.z * q.z) / 2.25f, turn_of(q)); }));
}

/// A square of triangles of very different size and shape.
TEST_P(EmissiveShape, MeshesShineUniformlyByArea) {
    Scene scene = scene_with_lamp();
    scene.integrator.light_samples = GetParam();
    MeshData mesh{.positions = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}, {0.3f, 0, 0.05f}, {0.25f, 0, 0.9f}},
                  .indices = {0, 1, 4, 1, 2, 4, 2, 5, 4, 2, 3, 5, 3, 0, 5, 0, 4, 5}};
    add_triangle_mesh(scene, 1, std::move(mesh));
    const vec3 p(0.5f, 4, 0.2f);
    expect_uniform(counts_in_square(ways_to_lamp(scene, p), p, 16, [](vec3 q) { return vec2(q.x, q.z); }));
}

/// One row of all lights, and strata: cells of 3 x 3, of equal power.
INSTANTIATE_TEST_SUITE_P(Kernels, EmissiveShape, testing::Values(1u, 3u), [](const auto &info) { return "Rows" + std::to_string(info.param); });

}  // namespace brandung
