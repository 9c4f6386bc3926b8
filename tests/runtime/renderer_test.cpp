#include "runtime/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/probe.h"

namespace brandung {
namespace {

TEST(Renderer, KeepsThePictureSoFarWhereTheDeviceFails) {
    Scene scene;
    scene.background = Spectrum(1);
    scene.cameras.push_back({.name = "camera"});
    scene.film.width = scene.film.height = 4;
    RenderOptions options{.batch = 4, .on_progress = [](const RenderProgress &progress) {
                              if (progress.samples_done == 8) throw Error("out of memory");
                              return true;
                          }};
    const CompiledScene compiled = compile(scene);
    const DeviceScene on_device(test_device(), compiled);
    Film film(test_device(), 4, 4);
    Renderer renderer(test_device(), scene, compiled, on_device, scene.cameras[0], options);
    const RenderEnd end = renderer.render(film);
    EXPECT_FALSE(end.complete);
    EXPECT_EQ(end.failure, "out of memory");
    const std::vector<vec3> picture = film.develop();
    EXPECT_EQ(std::count(picture.begin(), picture.end(), vec3(1)), 8);
    EXPECT_EQ(std::count(picture.begin(), picture.end(), vec3(0)), 8);
}

}  // namespace
}  // namespace brandung
