/// Light at one point of a floor, estimated by a rendering whose pixels all see it.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/images/oracle.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"
#include "tests/support/statistics/means.h"
#include "tests/support/statistics/significance.h"

namespace brandung::irradiance {

using oracle::pi;
using oracle::Real;

/// Looks from `from` at a point of what material 0, of reflectance 1, is added as: so narrow that every pixel is another estimate of that point's
/// irradiance over pi. The lamp, material 1, has radiance 1.
inline Scene scene_seen_at(vec3 from, vec3 at) {
    Scene scene;
    scene.file = "emissive";
    CameraDescription camera;
    camera.from = from, camera.at = at, camera.up = {0.3f, 0.2f, 1}, camera.fov = 1e-4f;
    scene.cameras.push_back(camera);
    scene.film.width = 32, scene.film.height = 24, scene.film.spp = 16;
    scene.integrator.max_depth = 1;
    add_material(scene, matte(1)), add_material(scene, emitter(Spectrum(1)));
    return scene;
}

inline void add_quad(Scene &scene, uint material, vec3 corner, vec3 u, vec3 v) {
    MeshData mesh;
    append_polygon(scene, mesh, {corner, corner + u, corner + u + v, corner + v}, {});
    add_triangle_mesh(scene, material, std::move(mesh));
}

inline void add_floor(Scene &scene) { add_quad(scene, 0, {-50, 0, 50}, {100, 0, 0}, {0, 0, -100}); }

/// Of the samples, in units of the film's.
struct Estimate {
    Real mean, variance;  ///< of one sample
    std::uint64_t samples, shadow_rays, shadow_hits;
    Real error() const { return std::sqrt(variance / Real(samples)); }
};

inline Estimate estimate(const Scene &scene) {
    const Rendering rendering = render_scene(scene);
    EXPECT_EQ(rendering.refused, 0u);
    EXPECT_EQ(rendering.clamped, 0u);
    Real sum = 0, squares = 0, samples = 0;
    for (const FilmPixel &pixel : rendering.film) {
        sum += static_cast<Real>(sum_of(pixel, 0)) * 0x1p-32L;
        squares += static_cast<Real>(squares_of(pixel, 0)) * 0x1p-64L;
        samples += pixel.counts[0] + pixel.counts[1];
    }
    const Real mean = sum / samples;
    return {mean, std::max(squares / samples - mean * mean, 0.0L), std::uint64_t(samples), rendering.counts.rays[RAY_SHADOW],
            rendering.counts.hits[RAY_SHADOW]};
}

/// The mean of the samples, to their statistics and the rounding of a picture, some 1e-5 of it.
inline void expect_mean(const Estimate &estimate, Real expected) {
    const double error = double(estimate.error()), rounding = 1e-5 * double(expected);
    const double p = statistics::p_of_difference({double(estimate.mean), error * error}, {double(expected), rounding * rounding});
    EXPECT_TRUE(statistics::plausible(p)) << estimate.mean << " instead of " << expected;
    EXPECT_LT(estimate.error(), 0.01L * expected) << "the test can tell";
}

/// Of the difference of two means (Welch's test).
inline double p_of(const Estimate &a, const Estimate &b) {
    return statistics::p_of_difference({double(a.mean), double(a.variance / Real(a.samples))},
                                       {double(b.mean), double(b.variance / Real(b.samples))});
}

/// Of the normal distribution: half the width of the interval that holds all but this part.
inline Real half_width(Real part) {
    Real low = 0, high = 10;
    for (int step = 0; step < 60; ++step) {
        const Real middle = (low + high) / 2;
        (std::erfc(middle / std::sqrt(2.0L)) > part ? low : high) = middle;
    }
    return low;
}

/// One of so many intervals that together hold the truth with 95 % (Šidák 1967), and that reach no further than a thousandth of it. Floats and the
/// film make about 1e-5 of the picture.
inline void expect_right_to_a_thousandth(const Estimate &estimate, Real expected, std::size_t intervals) {
    const Real reach = half_width(1 - std::pow(0.95L, 1 / Real(intervals))) * estimate.error();
    EXPECT_LE(reach, 1e-3L * expected);
    EXPECT_LE(std::abs(estimate.mean - expected), reach + 1e-5L * expected) << estimate.mean / expected;
}

/// Form factor from a surface element to a parallel rectangle, one of whose corners is straight above it: sides over height a and b (Howell, C-11).
inline Real corner_factor(Real a, Real b) {
    const Real p = std::sqrt(1 + a * a), q = std::sqrt(1 + b * b);
    return (a / p * std::atan(b / p) + b / q * std::atan(a / q)) / (2 * pi);
}

/// To the square [-1, 1]² at height 2, from (x, z): factors of corners are odd in both sides.
inline Real square_factor(Real x, Real z) {
    Real sum = 0;
    for (const Real u : {-1, 1})
        for (const Real v : {-1, 1}) sum += corner_factor((1 + u * x) / 2, (1 + v * z) / 2);
    return sum;
}

}  // namespace brandung::irradiance
