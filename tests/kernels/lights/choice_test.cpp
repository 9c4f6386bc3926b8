/// kernels/lights/choice.cl: lights are chosen as often as they are said to be, however many there are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene/compile.h"
#include "tests/support/probe.h"
#include "tests/support/scenes.h"
#include "tests/support/statistics/means.h"
#include "tests/support/statistics/significance.h"
#include "tests/support/traced_scene.h"

namespace brandung {
namespace {

constexpr uint choices = 1 << 23;

/// So many triangles, no two of which make a parallelogram, and as last light a lamp of half their power together.
Scene scene_with_lamps(uint faces) {
    Scene scene = empty_scene();
    scene.integrator.type = "path";
    add_sphere(scene, 0, {1e4f, 0, 0}, 1);  // without anything to light there are no lights
    add_material(scene, emitter(Spectrum(1)));
    MeshData mesh;
    for (uint i = 0; i < faces; ++i) {
        const vec3 corner(float(i % 1000) * 2, float(i / 1000) * 2, 0);
        for (const vec3 side : {vec3(0, 0, 0), vec3(1, 0, 0), vec3(0, 1, 0)}) {
            mesh.indices.push_back(uint(mesh.positions.size()));
            mesh.positions.push_back(corner + side);
        }
    }
    add_triangle_mesh(scene, 1, std::move(mesh));
    add_sphere(scene, 1, {0, 0, 1000}, std::sqrt(float(faces) / 4 / (4 * float(M_PI))));
    return scene;
}

/// How often the last light is chosen, by numbers u as even as a sampler's.
uint choices_of_last(const CompiledScene &compiled) {
    const DeviceScene on_device(test_device(), compiled);
    Sources sources = on_device.lists();
    sources["choose.cl"] = R"(#include "generated/instances.cl"
#include "kernels/core/random.cl"
#include "kernels/core/scene.cl"
#include "kernels/lights/choice.cl"
        kernel void choose(SCENE_PARAMS, uint shift, global uint *rows) {
            const Scene scene = SCENE;
            const uint i = get_global_id(0);
            rows[i] = light_chosen(scene, make3(0.0f, 0.0f, 0.0f), unit_interval(i << shift), hash(i)).row;
        })";
    Kernel kernel(test_device(), "choose.cl", "choose", sources, 1);
    const Buffer<uint> rows(test_device(), kernel.work_items(choices));
    kernel(choices, on_device, 32 - uint(std::log2(choices)), rows);
    const std::vector<uint> chosen = rows.read(0, choices);
    EXPECT_LT(*std::max_element(chosen.begin(), chosen.end()), compiled.header.light_choices.count);
    return uint(std::count(chosen.begin(), chosen.end(), compiled.header.light_choices.count - 1));
}

class LightChosen : public testing::TestWithParam<uint> {};

}  // namespace

/// Numbers u are even, so that what is left to chance is less than of independent choices: of these the test can tell a thousandth.
TEST_P(LightChosen, IsTheLampAsOftenAsItIsPowerful) {
    const double expected = choices / 3.0, error = std::sqrt(expected * 2 / 3);
    const double found = choices_of_last(compile(scene_with_lamps(GetParam())));
    EXPECT_TRUE(statistics::plausible(statistics::p_of_difference({found, error * error}, {expected, 0}))) << found / expected;
    EXPECT_LT(error, 1e-3 * expected) << "the test can tell";
}

INSTANTIATE_TEST_SUITE_P(Kernels, LightChosen, testing::Values(1u, 1000u, 100000u),
                         [](const auto &info) { return "Faces" + std::to_string(info.param); });

}  // namespace brandung
