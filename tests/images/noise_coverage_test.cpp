/// The noise of renders whose limit is known: how often its interval holds the error of the picture.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

#include "runtime/wavefront/noise.h"
#include "scene/bsdfs/bsdf.h"
#include "tests/support/filters.h"
#include "tests/support/probe.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

constexpr uint width = 48, height = 32;
constexpr double half_height = 0.2;  ///< of the picture at distance 1

/// The eye is in the origin and looks along -z: picture point (x, y) in pixels is seen in direction (x', y', -1).
glm::dvec3 direction(double x, double y) {
    const double scale = 2 * half_height / height;
    return {(x - width / 2.0) * scale, (height / 2.0 - y) * scale, -1};
}

Scene scene_before_eye(uint spp) {
    Scene scene;
    scene.file = "noise";
    scene.cameras.push_back({.name = "camera", .from = {0, 0, 0}, .at = {0, 0, -1}, .up = {0, 1, 0}, .fov = float(2 * std::atan(half_height))});
    scene.film.width = width, scene.film.height = height, scene.film.spp = spp;
    scene.integrator.light_samples = 0;
    return scene;
}

/// The mean over a pixel of what is seen in a direction, where that varies slowly.
double pixel_mean(uint x, uint y, double (*radiance)(glm::dvec3)) {
    constexpr uint n = 8;
    double sum = 0;
    for (uint i = 0; i < n; ++i)
        for (uint j = 0; j < n; ++j) sum += radiance(direction(x + (i + 0.5) / n, y + (j + 0.5) / n));
    return sum / (n * n);
}

/// The same, weighed by a tent about the pixel's middle, as far as the picture reaches.
double tent_mean(uint x, uint y, double (*radiance)(glm::dvec3)) {
    constexpr int n = 8;
    double sum = 0, weights = 0;
    for (int i = -n; i < n; ++i)
        for (int j = -n; j < n; ++j) {
            const double dx = (i + 0.5) / n, dy = (j + 0.5) / n, px = x + 0.5 + dx, py = y + 0.5 + dy;
            if (px < 0 || px > width || py < 0 || py > height) continue;
            const double weight = (1 - std::abs(dx)) * (1 - std::abs(dy));
            sum += weight * radiance(direction(px, py)), weights += weight;
        }
    return sum / weights;
}

double fresnel(double cosine, double eta) {
    const double beyond = std::sqrt(1 - (1 - cosine * cosine) / (eta * eta));
    const double s = (cosine - eta * beyond) / (cosine + eta * beyond), p = (beyond - eta * cosine) / (beyond + eta * cosine);
    return (s * s + p * p) / 2;
}

// ---- a furnace: a ball of glass whose reflections are dimmed, in light that comes from everywhere --------------------------------------------

constexpr double dimmed = 0.5, ball_radius = 1, ball_distance = 1.2;

Scene furnace() {
    Scene scene = scene_before_eye(64);
    Whitted whitted{};
    whitted.reflection = Spectrum(float(dimmed)), whitted.transmission = Spectrum(1), whitted.fresnel = 1;
    Material material = make_material(whitted);
    material.eta = 1.5f;
    add_sphere(scene, add_material(scene, material), {0, 0, -float(ball_distance)}, float(ball_radius));
    scene.background = Spectrum(1), scene.integrator.follows_one = true, scene.integrator.max_depth = 40;
    return scene;
}

/// Within the ball all angles are equal: dimmed F of each reflection, 1 - F of each way in and out.
double furnace_radiance(glm::dvec3 d) {
    d = glm::normalize(d);
    const glm::dvec3 centre(0, 0, -ball_distance);
    const double along = glm::dot(d, centre), closest = std::sqrt(ball_distance * ball_distance - along * along);
    const double f = fresnel(std::sqrt(1 - closest * closest / (ball_radius * ball_radius)), 1.5);
    return dimmed * f + (1 - f) * (1 - f) / (1 - dimmed * f);
}

// ---- a pane of glass under an angle: bright by reflection, darker by refraction -------------------------------------------------------------

const glm::dvec3 pane_normal = glm::normalize(glm::dvec3(0, 1, 0.35));

Scene pane() {
    Scene scene = scene_before_eye(64);
    Whitted whitted{};
    whitted.reflection = Spectrum(1), whitted.transmission = Spectrum(1), whitted.fresnel = 1;
    Material material = make_material(whitted);
    material.eta = 1.5f;
    const vec3 n(pane_normal), right(1, 0, 0), forward = glm::cross(n, right), middle = {0, 0, -2};
    add_triangle(scene, add_material(scene, material), middle - 90.0f * right - 90.0f * forward, middle + 90.0f * right - 90.0f * forward,
                 middle + 90.0f * forward);
    // Refracted rays go down and meet a wall that shines, reflected ones go up.
    add_triangle(scene, add_material(scene, emitter(Spectrum(0.25f))), vec3(-900, -3, -300), vec3(0, -2000, -300), vec3(900, -3, -300));
    scene.background = Spectrum(1), scene.integrator.follows_one = true;
    return scene;
}

double pane_radiance(glm::dvec3 d) {
    const double f = fresnel(-glm::dot(glm::normalize(d), pane_normal), 1.5);
    return f + (1 - f) * 0.25;
}

// ---- stripes that shine, at an angle to the pixels: only where in a pixel samples lie counts ------------------------------------------------

using Polygon = std::vector<glm::dvec2>;
constexpr int stripe_first = -8, stripe_end = 12;

/// In pixels: 1.4 wide and 3.1 apart, turned by 0.4; across the picture lie -19 to 30.
Polygon stripe(int number) {
    const glm::dvec2 along(std::cos(0.4), std::sin(0.4)), across(-along.y, along.x), from = across * (3.1 * number);
    return {from - 99.0 * along, from + 99.0 * along, from + 99.0 * along + 1.4 * across, from - 99.0 * along + 1.4 * across};
}

Scene stripes() {
    Scene scene = scene_before_eye(16);
    const uint shining = add_material(scene, emitter(Spectrum(1)));
    for (int number = stripe_first; number < stripe_end; ++number) {
        std::vector<vec3> corners;
        for (const glm::dvec2 &p : stripe(number)) corners.emplace_back(direction(p.x, p.y));
        add_triangle(scene, shining, corners[0], corners[1], corners[2]), add_triangle(scene, shining, corners[0], corners[2], corners[3]);
    }
    scene.background = Spectrum(0.25f);
    return scene;
}

/// What of a polygon has a p.x + b p.y <= c.
Polygon clipped(const Polygon &polygon, double a, double b, double c) {
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
        const double of_p = c - a * p.x - b * p.y, of_q = c - a * q.x - b * q.y;
        if (of_p >= 0) result.push_back(p);
        if ((of_p < 0) != (of_q < 0)) result.push_back(p + (q - p) * (of_p / (of_p - of_q)));
    }
    return result;
}

double area(const Polygon &polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
        twice += p.x * q.y - p.y * q.x;
    }
    return std::abs(twice) / 2;
}

double covered(uint x, uint y) {
    double sum = 0;
    for (int number = stripe_first; number < stripe_end; ++number)
        sum += area(clipped(clipped(clipped(clipped(stripe(number), -1, 0, -double(x)), 1, 0, x + 1), 0, -1, -double(y)), 0, 1, y + 1));
    return sum;
}

Scene splatted(Scene (*make)()) {
    Scene scene = make();
    scene.film.filter = filter_number("tent"), scene.film.filter_radius = 1, scene.film.splat = true;
    return scene;
}
Scene splatted_furnace() { return splatted(furnace); }
Scene splatted_pane() { return splatted(pane); }
double splatted_furnace_limit(uint x, uint y) { return tent_mean(x, y, furnace_radiance); }
double splatted_pane_limit(uint x, uint y) { return tent_mean(x, y, pane_radiance); }

double furnace_limit(uint x, uint y) { return pixel_mean(x, y, furnace_radiance); }
double pane_limit(uint x, uint y) { return pixel_mean(x, y, pane_radiance); }
double stripes_limit(uint x, uint y) { return 0.25 + 0.75 * covered(x, y); }

struct Known {
    const char *name;
    Scene (*make)();
    double (*limit)(uint x, uint y);
};
void PrintTo(const Known &known, std::ostream *out) { *out << known.name; }

double relmse(const std::vector<vec3> &picture, const std::vector<double> &limits) {
    double sum = 0;
    for (std::size_t i = 0; i < limits.size(); ++i) {
        const double error = double(picture[i].x) - limits[i];
        sum += error * error / (limits[i] * limits[i] + 0.01) / double(limits.size());
    }
    return sum;
}

class NoiseOf : public testing::TestWithParam<Known> {};

/// So many by default; BRANDUNG_RUNS=1000 for a finer look.
uint number_of_runs() {
    const char *text = std::getenv("BRANDUNG_RUNS");
    return text ? uint(std::atoi(text)) : 150;
}

/// Of n intervals of 95 % at least 95 % - 3 sqrt(0.95 * 0.05 / n) hold the error. That they are not too wide show errors over estimates, by their
/// logarithms in standard deviations of the interval: these have a variance of 1, within three of its own, sqrt(2 / n), and a tenth more, since the
/// kurtosis of stratified samples leaves open by how much it is below.
TEST_P(NoiseOf, HoldsTheErrorOfThePicture) {
    const uint runs = number_of_runs();
    Scene scene = GetParam().make();
    std::vector<double> limits;
    for (uint y = 0; y < height; ++y)
        for (uint x = 0; x < width; ++x) limits.push_back(GetParam().limit(x, y));
    const CompiledScene compiled = compile(scene);
    const DeviceScene on_device(test_device(), compiled);
    uint inside = 0;
    double estimates = 0, errors = 0, deviations_squared = 0;
    for (uint run = 0; run < runs; ++run) {
        scene.film.seed = run;
        Film film(test_device(), scene.film);
        Renderer renderer(test_device(), scene, compiled, on_device, scene.cameras[0], {.batch = 8192});
        const RenderEnd end = renderer.render(film);
        const double error = relmse(film.develop(), limits);
        inside += error >= end.noise->low && error <= end.noise->high;
        estimates += end.noise->relmse, errors += error;
        const double deviations = 1.95996398 * std::log(error / end.noise->relmse) / std::log(end.noise->high / end.noise->relmse);
        deviations_squared += deviations * deviations;
    }
    EXPECT_NEAR(deviations_squared / runs, 1, 3 * std::sqrt(2.0 / runs) + 0.1);
    EXPECT_GE(double(inside) / runs, 0.95 - 3 * std::sqrt(0.95 * 0.05 / runs));
    EXPECT_NEAR(estimates / errors, 1, 0.02);
    std::cout << "  the error is held by " << inside << " of " << runs << ", relMSE " << errors / runs << ", estimates over errors "
              << estimates / errors << ", variance of deviations " << deviations_squared / runs << '\n';
}

INSTANTIATE_TEST_SUITE_P(Renders, NoiseOf,
                         testing::Values(Known{"Furnace", furnace, furnace_limit}, Known{"Pane", pane, pane_limit},
                                         Known{"Stripes", stripes, stripes_limit}, Known{"SplattedFurnace", splatted_furnace, splatted_furnace_limit},
                                         Known{"SplattedPane", splatted_pane, splatted_pane_limit}),
                         [](const auto &info) { return info.param.name; });

}  // namespace
}  // namespace brandung
