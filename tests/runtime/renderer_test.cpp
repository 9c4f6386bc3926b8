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
    const CompiledScene compiled = compile(scene);
    const DeviceScene on_device(test_device(), compiled);
    Film film(test_device(), Window{0, 0, 4, 4});
    Renderer renderer(test_device(), scene, compiled, on_device, scene.cameras[0], {.batch = 4});
    const auto fail = [](const RenderProgress &progress) {
        if (progress.samples_done == 8) throw Error("out of memory");
        return true;
    };
    const RenderEnd end = renderer.render(film, {{0, fail}});
    EXPECT_FALSE(end.complete());
    EXPECT_EQ(end.failure, "out of memory");
    const std::vector<vec3> picture = film.develop();
    EXPECT_EQ(std::count(picture.begin(), picture.end(), vec3(1)), 8);
    EXPECT_EQ(std::count(picture.begin(), picture.end(), vec3(0)), 8);
}

/// Four pixels in every batch: who asks to is told after each, and sees what there is; who asks for an hour is not told.
TEST(Renderer, ObserversSeeTheFilmOfARenderUnderWay) {
    Scene scene;
    scene.background = Spectrum(1);
    scene.cameras.push_back({.name = "camera"});
    scene.film.width = scene.film.height = 4;
    const CompiledScene compiled = compile(scene);
    const DeviceScene on_device(test_device(), compiled);
    Film film(test_device(), Window{0, 0, 4, 4});
    Renderer renderer(test_device(), scene, compiled, on_device, scene.cameras[0], {.batch = 4});
    std::vector<std::uint64_t> seen;
    const auto look = [&](const RenderProgress &progress) {
        const std::vector<vec3> picture = film.develop();
        EXPECT_EQ(std::count(picture.begin(), picture.end(), vec3(1)), std::ptrdiff_t(progress.samples_done));
        seen.push_back(progress.samples_done);
        return true;
    };
    const auto never = [](const RenderProgress &) {
        ADD_FAILURE() << "not yet";
        return true;
    };
    EXPECT_TRUE(renderer.render(film, {{3600, never}, {0, look}}).complete());
    EXPECT_EQ(seen, (std::vector<std::uint64_t>{4, 8, 12, 16}));

    film.clear(), seen.clear();
    const auto stop = [](const RenderProgress &progress) { return progress.samples_done < 8; };
    const RenderEnd end = renderer.render(film, {{0, look}, {0, stop}, {0, look}});
    EXPECT_FALSE(end.complete());
    EXPECT_EQ(end.failure, "");
    EXPECT_EQ(end.samples_done, 8u);
    EXPECT_EQ(seen, (std::vector<std::uint64_t>{4, 4, 8, 8})) << "all are told before it ends";
}

}  // namespace
}  // namespace brandung
