/// What path tracing says that its pictures lack.
#include <gtest/gtest.h>

#include <utility>

#include "runtime/renderer.h"
#include "scene/bsdfs/choosing.h"
#include "scene/kinds.h"
#include "tests/support/probe.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

struct Report {
    std::string biases, not_shown;
};

/// Of one path per pixel, to this depth.
Report report_of(Scene scene, uint depth) {
    scene.integrator.type = "path", scene.integrator.max_depth = depth;
    scene.film.width = 16, scene.film.height = 12;
    const CompiledScene compiled = compile(scene);
    const DeviceScene on_device(test_device(), compiled);
    Film film(test_device(), scene.film.window());
    Renderer renderer(test_device(), scene, compiled, on_device, scene.cameras.at(0), {});
    EXPECT_TRUE(renderer.render(film).complete());
    Report report;
    for (const Bias &bias : renderer.integrator().biases()) report.biases += bias.why + "; ";
    for (const NotShown &one : renderer.integrator().not_shown()) report.not_shown += one.name + "; ";
    return report;
}

/// Within a sphere, which all rays meet.
Scene within(const Material &material) {
    Scene scene;
    scene.file = "within";
    scene.cameras.push_back({.name = "camera", .from = {0, 0, 0.5f}});
    add_sphere(scene, add_material(scene, material), {0, 0, 0}, 1);
    return scene;
}

Material mask_of(Scene &scene) {
    const uint member = add_material(scene, matte(0.5f));
    return make_choosing(choosing_kinds()[kind_number(choosing_kinds(), "mask")], {{NO_MATERIAL, member}, 0, Spectrum(0.5f)});
}

}  // namespace

/// Of 192 paths, each of whose second surface is the last that throws light on.
TEST(PathReports, DepthHasCutWhatWouldHaveThrownLightOn) {
    EXPECT_EQ(report_of(within(matte(0.5f)), 2).biases, "integrator.max_depth 2 ended 192 paths whose surface sends more; ");
    EXPECT_EQ(report_of(within(mirror(0.5f)), 2).biases, "integrator.max_depth 2 ended 192 paths whose surface sends more; ");
}

/// What shines and reflects nothing ends a path, and so does the background.
TEST(PathReports, DepthHasCutNoPathThatEndsByItself) {
    Scene lamp = within(matte(0.5f));
    lamp.shapes.clear();
    add_sphere(lamp, add_material(lamp, emitter(Spectrum(1))), {0, 0, 0}, 1);
    add_sphere(lamp, 0, {0, 0, -0.5f}, 0.3f);
    lamp.integrator.light_samples = 0;
    EXPECT_EQ(report_of(std::move(lamp), 1).biases, "");

    Scene ball = within(matte(0.5f));
    ball.cameras[0].from = {0, 0, 4}, ball.background = Spectrum(1);
    EXPECT_EQ(report_of(std::move(ball), 1).biases, "");
}

TEST(PathReports, LightsWithoutSizeAreMissedOnlyWhereTheyWouldHaveToBeMet) {
    const auto missed = [](Scene scene) {
        scene.lights.push_back(point_light({0, 0, 0}, Spectrum(1)));
        return report_of(std::move(scene), 1).not_shown;
    };
    const std::string told = "light of points and directions over mirrors, through smooth glass and masks; ";
    EXPECT_EQ(missed(within(matte(0.5f))), "");
    EXPECT_EQ(missed(within(mirror(0.5f))), told);
    EXPECT_EQ(missed(within(glass(1.5f))), told);
    EXPECT_EQ(report_of(within(mirror(0.5f)), 1).not_shown, "");
    Scene masked = within(matte(0.5f));
    masked.shapes.clear();
    add_sphere(masked, add_material(masked, mask_of(masked)), {0, 0, 0}, 1);
    EXPECT_EQ(missed(std::move(masked)), told);
}

}  // namespace brandung
