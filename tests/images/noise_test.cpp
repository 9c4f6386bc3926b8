/// Noise: errors that a film knows are true, and what is chosen at random in several places is independent.
#include <gtest/gtest.h>

#include "scene/bsdfs/bsdf.h"
#include "tests/images/irradiance.h"
#include "tests/support/statistics/blocks.h"
#include "tests/support/statistics/significance.h"
#include "tests/support/statistics/uniformity.h"

namespace {

using namespace brandung;
using namespace irradiance;
using statistics::plausible;

/// Every sample is a point of the lamp chosen anew, so that samples are independent.
Scene noisy_scene(uint seed) {
    Scene scene = scene_seen_at({4, 1, 0.5f}, {0, 0, 0});
    scene.film.seed = seed;
    add_floor(scene), add_quad(scene, 1, {-1, 2, -1}, {2, 0, 0}, {0, 0, 2});
    return scene;
}

double sum_of_half(const FilmPixel &pixel, uint half) { return double(value_of(pixel.sums[half][0])) * 0x1p-32; }

}  // namespace

/// Of pictures with different seeds blocks differ as their own errors say: Welch's p-values are uniform.
TEST(Noise, IsAsLargeAsItIsSaidToBe) {
    const auto one = statistics::estimates_of_blocks(render_scene(noisy_scene(1)).film, 32, {2, 2}, 0);
    const auto other = statistics::estimates_of_blocks(render_scene(noisy_scene(2)).film, 32, {2, 2}, 0);
    const std::vector<double> p_values = statistics::p_of_differences(one, other);
    EXPECT_EQ(p_values.size(), 16u * 12);
    EXPECT_TRUE(plausible(p_values));
    EXPECT_TRUE(plausible(statistics::uniformity_p(p_values)));
    const statistics::Estimate known{double(square_factor(0, 0)), 0};
    EXPECT_TRUE(plausible(statistics::p_of_differences(one, std::vector<statistics::Estimate>(one.size(), known))));
}

/// The lamp is a tenth brighter in the second picture: 1 % is the error of a block of 64 samples, of which there are 192.
TEST(Noise, DoesNotHideABrighterLamp) {
    const auto one = statistics::estimates_of_blocks(render_scene(noisy_scene(1)).film, 32, {2, 2}, 0);
    auto brighter = statistics::estimates_of_blocks(render_scene(noisy_scene(2)).film, 32, {2, 2}, 0);
    for (statistics::Estimate &estimate : brighter) estimate.mean *= 1.1;
    EXPECT_FALSE(plausible(statistics::p_of_differences(one, brighter)));
}

/// The product of what both halves of a pixel are off their mean is 0 in expectation, and their variances are equal.
TEST(Noise, OfBothHalvesIsIndependent) {
    const std::vector<FilmPixel> film = render_scene(noisy_scene(3)).film;
    const double expected = 8 * double(square_factor(0, 0));  // of 8 samples
    std::vector<double> products, excess;
    for (const FilmPixel &pixel : film) {
        const double even = sum_of_half(pixel, 0) - expected, odd = sum_of_half(pixel, 1) - expected;
        products.push_back(even * odd), excess.push_back(even * even - odd * odd);
    }
    EXPECT_TRUE(plausible(statistics::p_of_difference(statistics::estimate_of(products), {0})));
    EXPECT_TRUE(plausible(statistics::p_of_difference(statistics::estimate_of(excess), {0})));
}

/// The same lamp twice: of independent points the variance is twice that of one, of the same points four times. That of 12288 samples is known to
/// some 2 %.
TEST(Noise, OfTwoLampsIsIndependent) {
    Scene scene = noisy_scene(4);
    const Real one = estimate(scene).variance;
    add_quad(scene, 1, {-1, 2, -1}, {2, 0, 0}, {0, 0, 2});
    const Estimate both = estimate(scene);
    expect_mean(both, 2 * square_factor(0, 0));
    EXPECT_NEAR(both.variance / one, 2, 0.2);
}

/// A pane mirrors half of the ray to one wall and lets half of it through to another, both as far from each point of a lamp in the pane's plane: of
/// the same points their mean had the variance of one wall, of independent ones it has half of it.
TEST(Noise, OfMirroredAndRefractedRaysIsIndependent) {
    Scene scene = scene_seen_at({-1, 0, 1}, {0, 0, 0});
    scene.cameras[0].up = {0, 1, 0};
    scene.integrator.max_depth = 2;
    for (const float side : {-2.0f, 2.0f}) add_quad(scene, 0, {side, -9, -9}, {0, 18, 0}, {0, 0, 18});
    add_quad(scene, 1, {0, 1, -3}, {0, 2, 0}, {0, 0, 2});
    const Estimate straight = estimate(scene);
    Material pane = make_material(Whitted{.reflection = Spectrum(0.5f), .transmission = Spectrum(0.5f), .exponent = 1});
    pane.eta = 1;
    add_quad(scene, add_material(scene, pane), {0, -0.5f, -0.5f}, {0, 1, 0}, {0, 0, 1});
    const Estimate divided = estimate(scene);
    EXPECT_TRUE(plausible(statistics::p_of_difference({double(straight.mean), double(straight.error() * straight.error())},
                                                      {double(divided.mean), double(divided.error() * divided.error())})));
    EXPECT_NEAR(divided.variance / straight.variance, 0.5L, 0.05L);
}
