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
    Film film(test_device(), {0, 0, 4, 4});
    Renderer renderer(test_device(), scene, compiled, on_device, scene.cameras[0], options);
    const RenderEnd end = renderer.render(film);
    EXPECT_FALSE(end.complete);
    EXPECT_EQ(end.failure, "out of memory");
    const std::vector<vec3> picture = film.develop();
    EXPECT_EQ(std::count(picture.begin(), picture.end(), vec3(1)), 8);
    EXPECT_EQ(std::count(picture.begin(), picture.end(), vec3(0)), 8);
}

/// Four pixels in every batch: after the first half of them the observer sees it, and never the end.
TEST(Renderer, AnObserverSeesTheFilmOfARenderUnderWay) {
    Scene scene;
    scene.background = Spectrum(1);
    scene.cameras.push_back({.name = "camera"});
    scene.film.width = scene.film.height = 4;
    const CompiledScene compiled = compile(scene);
    const DeviceScene on_device(test_device(), compiled);
    Film film(test_device(), {0, 0, 4, 4});
    Renderer renderer(test_device(), scene, compiled, on_device, scene.cameras[0], {.batch = 4, .on_progress = nullptr});
    std::vector<std::uint64_t> seen;
    const auto look = [&](const RenderProgress &progress) {
        const std::vector<vec3> picture = film.develop();
        EXPECT_EQ(std::count(picture.begin(), picture.end(), vec3(1)), std::ptrdiff_t(progress.samples_done));
        seen.push_back(progress.samples_done);
    };
    EXPECT_TRUE(renderer.render(film, {0, look}).complete);
    EXPECT_EQ(seen, (std::vector<std::uint64_t>{4, 8, 12}));
    seen.clear();
    renderer.render(film, {3600, look});
    EXPECT_TRUE(seen.empty()) << "not yet";
}

}  // namespace
}  // namespace brandung
