/// Parts of pictures.
#include <gtest/gtest.h>

#include <cstring>

#include "tests/support/probe.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

Scene scene_of(uint width, uint height, uint spp) {
    Scene scene;
    scene.cameras.push_back({.name = "camera", .from = {0.2f, 0.4f, 3}, .at = {0, 0, 0}});
    scene.film.width = width, scene.film.height = height, scene.film.spp = spp;
    scene.background = {0.1f, 0.3f, 0.7f};
    add_soup(scene, add_material(scene, matte(0.7f)), {.of_each = 20, .size = 0.5f, .seed = 1});
    scene.lights.push_back(point_light({2, 3, 2}, {9, 8, 7}));
    return scene;
}

TEST(Crop, HasTheBitsOfTheSamePixelsOfTheWhole) {
    Scene scene = scene_of(37, 29, 3);
    const std::vector<FilmPixel> whole = render_scene(scene).film;
    for (const Window window : {Window{0, 0, 37, 29}, {5, 3, 20, 11}, {36, 28, 37, 29}, {0, 10, 37, 11}}) {
        scene.film.crop = window;
        for (const uint batch : {32768u, 100u}) {
            const Rendering part = render_scene(scene, {.batch = batch});
            ASSERT_EQ(part.film.size(), window.pixels());
            EXPECT_EQ(part.counts.rays[RAY_CAMERA], 3 * window.pixels()) << "nothing else is rendered";
            for (uint y = window.top; y < window.bottom; ++y)
                for (uint x = window.left; x < window.right; ++x)
                    ASSERT_EQ(std::memcmp(&part.film[(y - window.top) * window.width() + x - window.left], &whole[y * 37 + x], sizeof(FilmPixel)), 0)
                        << x << ", " << y;
        }
    }
}

TEST(Crop, TheFilmTakesTheWindowsMemoryAlone) {
    Film window(test_device(), Window{60000, 40000, 60100, 40050}), small(test_device(), Window{0, 0, 100, 50});
    EXPECT_EQ(window.bytes(), small.bytes());
}

}  // namespace
}  // namespace brandung
