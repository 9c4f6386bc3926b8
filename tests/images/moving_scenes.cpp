#include "tests/images/moving_scenes.h"

#include <gtest/gtest.h>

#include "scene/cameras/camera.h"
#include "scene/kinds.h"
#include "tests/support/rendering.h"
#include "tests/support/statistics/blocks.h"

namespace brandung::motion {

Scene scene_of(const std::string &integrator) {
    Scene scene;
    scene.file = "motion";
    scene.shutter = {0, 1};
    scene.cameras.push_back(
        {.name = "camera", .from = {0, 0, 10}, .at = {0, 0, 0}, .kind = kind_number(camera_kinds(), "orthographic"), .height = 6});
    scene.cameras[0].shutter = scene.shutter;
    scene.film.width = width, scene.film.height = height, scene.film.spp = 64;
    scene.integrator.type = integrator;
    add_material(scene, matte(0.5f));
    return scene;
}

uint ball(Scene &scene, uint material, float radius) {
    return group_of(scene, [&](Scene &s) { add_sphere(s, material, {0, 0, 0}, radius); });
}

uint bar(Scene &scene, uint material) {
    return group_of(scene, [&](Scene &s) {
        add_triangle(s, material, {-2, -0.15f, 0}, {2, -0.15f, 0}, {2, 0.15f, 0.1f});
        add_triangle(s, material, {-2, -0.15f, 0}, {2, 0.15f, 0.1f}, {-2, 0.15f, 0.1f});
        add_sphere(s, material, {1.8f, 0, 0}, 0.3f);
    });
}

void move(Scene &scene, uint group, const AffineMap &from, const AffineMap &to) {
    ASSERT_FALSE(add_instance(scene, group, Motion({{0, from}, {1, to}})));
}

Scene moving_scene(const std::string &integrator) {
    Scene scene = scene_of(integrator);
    scene.film.spp = 4;
    scene.background = Spectrum(0.3f);
    scene.lights.push_back(directional_light(glm::normalize(vec3(1, 2, 3)), Spectrum(1)));
    const uint shiny = add_material(scene, mirror(0.8f)), clear = add_material(scene, glass(1.5f));
    move(scene, bar(scene, 0), rotation(-40, {0, 0, 1}), rotation(100, {0, 0, 1}));
    move(scene, ball(scene, shiny, 0.7f), translation({-3, 1, -1}), then(scaling({2, 1, 0.5}), translation({1, 1, -1})));
    move(scene, ball(scene, clear, 0.8f), translation({1, -2, 2}), translation({2, 0, 2}));
    move(scene, bar(scene, add_material(scene, emitter(Spectrum(2)))), translation({0, 4, 0}), then(rotation(30, {0, 0, 1}), translation({1, 3, 0})));
    EXPECT_FALSE(add_instance(scene, ball(scene, 0, 0.9f), translation({0, -2, 0})));
    add_sphere(scene, 0, {0, 0, -4}, 2);
    return scene;
}

Scene shining_scene() {
    Scene scene = scene_of("path");
    scene.integrator.light_samples = 0, scene.film.spp = 1024;
    add_material(scene, emitter(Spectrum(1)));
    return scene;
}

std::vector<statistics::Estimate> blocks_of(const Scene &scene) {
    return statistics::estimates_of_blocks(render_scene(scene).film, width, {4, 4}, 0);
}

std::vector<statistics::Estimate> mean_of_stills(const std::function<Scene(double time)> &at) {
    constexpr uint times = 64;
    Random random(5);
    std::vector<std::vector<statistics::Estimate>> stills;
    for (uint i = 0; i < times; ++i) {
        Scene still = at((i + double(random.uniform(0, 1))) / times);
        still.film.spp = 16, still.film.seed = i + 1;
        const auto blocks = blocks_of(still);
        stills.resize(blocks.size());
        for (std::size_t b = 0; b < blocks.size(); ++b) stills[b].push_back(blocks[b]);
    }
    std::vector<statistics::Estimate> result;
    for (const auto &blocks : stills) result.push_back(statistics::mean_of(blocks));
    // What the stills' own times add, one anywhere in each 64th, is not in the estimates: within that what is seen moves by a quarter of a pixel at
    // most, so that a block's mean changes by less than a tenth.
    for (statistics::Estimate &estimate : result) estimate.variance += 0.1 * 0.1 / (12.0 * times);
    return result;
}

}  // namespace brandung::motion
