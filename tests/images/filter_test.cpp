/// Whole pictures through reconstruction filters.
#include <gtest/gtest.h>

#include "tests/support/filters.h"
#include "tests/support/probe.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"
#include "tests/support/statistics/blocks.h"
#include "tests/support/statistics/significance.h"

namespace brandung {
namespace {

Scene empty_scene(const std::string &filter, uint width, uint height, uint spp) {
    Scene scene;
    scene.cameras.push_back({.name = "camera", .from = {0, 0, 1}, .at = {0, 0, 0}, .fov = glm::radians(45.0f)});
    scene.film.width = width, scene.film.height = height, scene.film.spp = spp;
    scene.film.filter = filter_number(filter), scene.film.filter_radius = filter_kinds()[scene.film.filter].radius;
    add_material(scene, matte(0.5f));
    return scene;
}

/// White left of `edge` [pixels from the left], black right of it.
Scene edge_scene(const std::string &filter, uint width, uint height, uint spp, double edge) {
    Scene scene = empty_scene(filter, width, height, spp);
    // The picture plane at distance 1 is 2 tan(fov / 2) high.
    const float pixel = 2 * std::tan(glm::radians(22.5f)) / float(height), x = float(edge - width / 2.0) * pixel;
    add_triangle(scene, add_material(scene, emitter(Spectrum(1))), {x, -100, 0}, {x, 100, 0}, {x - 100, 0, 0});
    return scene;
}

class PictureThrough : public testing::TestWithParam<std::string> {};

/// Weights are all 1, or ±norm². Their mean over n samples, 1 in expectation, has a standard deviation of at most sqrt((norm⁴ - 1) / n).
TEST_P(PictureThrough, AConstantStaysWhatItIs) {
    Scene scene = empty_scene(GetParam(), 64, 64, 16);
    scene.background = {0.3f, 0.7f, 1000};
    const Rendering rendering = render_scene(scene);
    const double norm = filter_norm(GetParam(), scene.film.filter_radius);
    glm::dvec3 sum(0);
    for (const vec3 &pixel : rendering.picture) {
        if (GetParam() != "mitchell") {
            ASSERT_EQ(pixel, scene.background);
        }
        sum += glm::dvec3(pixel);
    }
    const double bound = GetParam() == "mitchell" ? 5 * std::sqrt((std::pow(norm, 4) - 1) / (64 * 64 * 16)) : 1e-7;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c] / (64 * 64) / scene.background[c], 1, bound);
}

/// A column's mean is the part of the filter's integral left of the edge, but for some 1e-6 by which the edge is off.
TEST_P(PictureThrough, AnEdgeBecomesTheFiltersIntegral) {
    constexpr uint width = 12, height = 32;
    const double edge = 6.3;
    const Scene scene = edge_scene(GetParam(), width, height, 256, edge);
    const double radius = scene.film.filter_radius, all = filter_integral(GetParam(), radius, -radius, radius, false);
    std::vector<statistics::Estimate> expected;
    for (uint x = 0; x < width; ++x) {
        const double reach = std::clamp(edge - (x + 0.5), -radius, radius);
        expected.push_back({filter_integral(GetParam(), radius, -radius, reach, false) / all, 1e-12});
    }
    const auto columns = statistics::estimates_of_blocks(render_scene(scene).film, width, {1, height}, 0);
    EXPECT_TRUE(statistics::plausible(statistics::p_of_differences(columns, expected)));
}

TEST_P(PictureThrough, HasTheSameBitsForEveryBatch) {
    const Scene scene = edge_scene(GetParam(), 13, 7, 9, 6.3);
    const std::uint64_t hash = film_hash(render_scene(scene).film);
    for (const uint batch : {1u, 7u, 100u, 1u << 17}) EXPECT_EQ(hash, film_hash(render_scene(scene, {.batch = batch}).film)) << batch;
}

/// A single sample in the middle is drawn from no filter.
TEST_P(PictureThrough, OneSampleInTheMiddleIsTheBoxs) {
    EXPECT_EQ(film_hash(render_scene(edge_scene(GetParam(), 13, 7, 1, 6.3)).film), film_hash(render_scene(edge_scene("box", 13, 7, 1, 6.3)).film));
}

/// Filters whose samples may be splatted.
std::vector<std::string> splat_names() {
    std::vector<std::string> names = filter_names();
    std::erase_if(names, [](const std::string &name) { return name == "box" || name == "mitchell"; });
    return names;
}

class SplatsThrough : public testing::TestWithParam<std::string> {};

TEST_P(SplatsThrough, AConstantStaysWhatItIs) {
    Scene scene = empty_scene(GetParam(), 32, 32, 4);
    scene.film.splat = true;
    scene.background = {0.3f, 0.7f, 1000};
    for (const vec3 &pixel : render_scene(scene).picture)
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(pixel[c] / scene.background[c], 1, 1e-6);
}

/// Of columns whose filters do not end beyond the picture.
TEST_P(SplatsThrough, AnEdgeBecomesTheFiltersIntegral) {
    constexpr uint width = 12, height = 32;
    const double edge = 6.3;
    Scene scene = edge_scene(GetParam(), width, height, 1024, edge);
    scene.film.splat = true;
    const double radius = scene.film.filter_radius, all = filter_integral(GetParam(), radius, -radius, radius, false);
    const std::vector<vec3> picture = render_scene(scene).picture;
    for (uint x = 2; x < width - 2; ++x) {
        double mean = 0;
        for (uint y = 0; y < height; ++y) mean += double(picture[y * width + x].x) / height;
        EXPECT_NEAR(mean, filter_integral(GetParam(), radius, -radius, std::clamp(edge - (x + 0.5), -radius, radius), false) / all, 3e-4) << x;
    }
}

/// Splats of the picture's edges are one-sided, by less than the filter's width; within, the mean is that of samples drawn from the filter.
TEST_P(SplatsThrough, HasTheMeanOfDrawnSamples) {
    Scene scene = edge_scene(GetParam(), 24, 16, 64, 11.7);
    const std::vector<vec3> drawn = render_scene(scene).picture;
    scene.film.splat = true;
    const std::vector<vec3> splatted = render_scene(scene).picture;
    double difference = 0, mean = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i) difference += double(splatted[i].x - drawn[i].x), mean += double(drawn[i].x);
    EXPECT_NEAR(difference / mean, 0, 2e-3);
}

/// Of sums and weights.
std::vector<std::uint64_t> splatted_bits(const Scene &scene, uint batch, Kinds kinds) {
    const CompiledScene compiled = compile(scene, {.kinds = kinds});
    const DeviceScene on_device(test_device(), compiled);
    Film film(test_device(), scene.film);
    EXPECT_TRUE(Renderer(test_device(), scene, compiled, on_device, scene.cameras[0], {.batch = batch}).render(film).complete());
    std::vector<std::uint64_t> bits = {film_hash(film.read())};
    for (const PixelWeights &weights : film.read_weights())
        for (const uint half : {0u, 1u}) bits.push_back(weights.sums[half]), bits.push_back(weights.squares[half]);
    return bits;
}

TEST_P(SplatsThrough, HasTheSameBitsForEveryBatchAndAllKinds) {
    Scene scene = edge_scene(GetParam(), 13, 7, 9, 6.3);
    scene.film.splat = true;
    const std::vector<std::uint64_t> bits = splatted_bits(scene, 32768, Kinds::in_use);
    EXPECT_EQ(bits.size(), 1 + 13 * 7 * 4u);
    for (const uint batch : {1u, 7u, 100u, 1u << 17}) EXPECT_EQ(bits, splatted_bits(scene, batch, Kinds::in_use)) << batch;
    EXPECT_EQ(bits, splatted_bits(scene, 100, Kinds::all));
}

/// Neighbours beyond the part count in it.
TEST_P(SplatsThrough, APartOfThePictureIsThatOfTheWhole) {
    Scene scene = edge_scene(GetParam(), 13, 9, 5, 6.3);
    scene.film.splat = true;
    const std::vector<vec3> whole = render_scene(scene).picture;
    for (const Window window : {Window{0, 0, 13, 9}, {5, 3, 8, 4}, {12, 8, 13, 9}, {0, 0, 1, 9}}) {
        scene.film.crop = window;
        const std::vector<vec3> part = render_scene(scene, {.batch = 50}).picture;
        for (uint y = window.top; y < window.bottom; ++y)
            for (uint x = window.left; x < window.right; ++x)
                ASSERT_EQ(part[(y - window.top) * window.width() + x - window.left], whole[y * 13 + x]) << x << ", " << y;
    }
}

INSTANTIATE_TEST_SUITE_P(Images, SplatsThrough, testing::ValuesIn(splat_names()), [](const auto &info) { return info.param; });

INSTANTIATE_TEST_SUITE_P(Images, PictureThrough, testing::ValuesIn(filter_names()), [](const auto &info) { return info.param; });

}  // namespace
}  // namespace brandung
