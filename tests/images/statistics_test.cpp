/// Every count of a render against a recount: from arrays read back, from the scene's geometry, or from other counts.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "scene/bsdfs/bsdf.h"
#include "scene/lights/light.h"
#include "tests/images/oracle.h"
#include "tests/support/probe.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_scene.h"

namespace {

using namespace brandung;
using oracle::Line;
using oracle::Real;
using oracle::Vec;

Scene scene_seen_from(vec3 from, vec3 at, float degrees, uint size) {
    Scene scene;
    scene.file = "counts";
    CameraDescription camera;
    camera.from = from, camera.at = at, camera.fov = glm::radians(degrees);
    scene.cameras.push_back(camera);
    scene.film.width = scene.film.height = size;
    return scene;
}

/// A device of its own, so that its profile has this render only.
struct Profiled {
    explicit Profiled(const Scene &scene, uint batch = 65536) {
        Device device = Device::select();
        const CompiledScene compiled = compile(scene);
        const DeviceScene on_device(device, compiled);
        Film film(device, scene.film.window());
        Renderer renderer(device, scene, compiled, on_device, scene.cameras.at(0), {.batch = batch});
        renderer.render(film);
        device.finish();
        counts = renderer.integrator().counts(), profile = device.profile();
    }
    std::uint64_t items(const std::string &kernel) const { return profile.contains(kernel) ? profile.at(kernel).items : 0; }
    RayCounts counts;
    Profile profile;
};

Scene soup(bool with_mirrors, bool with_glass) {
    Scene scene = scene_seen_from({0, 0, 4}, {0, 0, 0}, 40, 50);
    add_soup(scene, add_material(scene, matte(0.5f)), {.of_each = 25, .size = 0.4f});
    if (with_mirrors) add_soup(scene, add_material(scene, mirror(0.5f)), {.counts = {{"sphere", 20}}, .size = 0.4f, .seed = 2});
    if (with_glass) {  // apart, so that no interface is hidden
        const uint clear = add_material(scene, glass(1.5f));
        for (int corner = 0; corner < 8; ++corner)
            add_sphere(scene, clear, {corner & 1 ? 0.6f : -0.6f, corner & 2 ? 0.6f : -0.6f, corner & 4 ? 0.6f : -0.6f}, 0.4f);
    }
    scene.lights = {point_light({2, 2, 2}, Spectrum(1)), point_light({-2, 2, 2}, Spectrum(1)), directional_light({0, 1, 0}, Spectrum(1))};
    return scene;
}

}  // namespace

/// The tracing stages' tallies are what their results say, per kind of ray.
TEST(Counts, OfTracingStagesAreThoseOfTheHitsReadBack) {
    Scene scene = soup(false, false);
    for (const char *accelerator : {"wide_bvh", "none"}) {
        TracedScene traced(scene, accelerator);
        Random random(7);
        std::vector<Ray> rays;
        for (uint i = 0; i < 5003; ++i) rays.push_back(make_ray(random.in_cube(2), random.direction(), i % 5 == 0 ? 0.5f : INFINITY, i * i % 3));
        const auto expect_tally = [&](const std::vector<Hit> &hits) {
            Tally expected{};
            for (std::size_t i = 0; i < rays.size(); ++i)
                expected.rays[RAY_KIND(rays[i].tag)] += 1, expected.hits[RAY_KIND(rays[i].tag)] += hits[i].primitive != NO_HIT;
            for (uint kind = 0; kind < RAY_KINDS; ++kind) {
                EXPECT_EQ(traced.tally().rays[kind], expected.rays[kind]) << accelerator << ", kind " << kind;
                EXPECT_EQ(traced.tally().hits[kind], expected.hits[kind]) << accelerator << ", kind " << kind;
            }
            EXPECT_GT(expected.hits[RAY_CAMERA], 100u);
        };
        for (const Traversal &traversal : traced.traversals()) {
            expect_tally(traced.closest_hits(traversal, rays));
            const std::vector<std::uint8_t> visible = traced.visible(traversal, rays);
            EXPECT_EQ(traced.tally().rays[RAY_SHADOW], rays.size()) << traversal.name;
            EXPECT_EQ(traced.tally().hits[RAY_SHADOW], std::count(visible.begin(), visible.end(), 0)) << traversal.name;
        }
    }
}

/// In a closed convex room of mirrors every ray meets a wall, and every wall sees every lamp.
TEST(Counts, InARoomOfMirrorsFollowFromDepth) {
    for (const uint depth : {1u, 4u, 7u}) {
        Scene scene = scene_seen_from({0.1f, 0.2f, 0.3f}, {1, -0.2f, 0.5f}, 60, 30);
        scene.integrator.max_depth = depth;
        const Material walls = make_material(Whitted{.diffuse = Spectrum(0.5f), .reflection = Spectrum(0.5f), .exponent = 1});
        add_sphere(scene, add_material(scene, walls), {0, 0, 0}, 1);
        for (int i = 0; i < 11; ++i) scene.lights.push_back(point_light({0.05f * static_cast<float>(i), 0, 0}, Spectrum(1)));
        const RayCounts counts = render_scene(scene).counts;
        const std::uint64_t pixels = 30 * 30;
        EXPECT_EQ(counts.rays[RAY_CAMERA], pixels);
        EXPECT_EQ(counts.hits[RAY_CAMERA], pixels);
        EXPECT_EQ(counts.rays[RAY_REFLECTED], pixels * (depth - 1));
        EXPECT_EQ(counts.hits[RAY_REFLECTED], pixels * (depth - 1));
        EXPECT_EQ(counts.rays[RAY_REFRACTED], 0u);
        EXPECT_EQ(counts.rays[RAY_SHADOW], pixels * depth * 11);
        EXPECT_EQ(counts.hits[RAY_SHADOW], 0u);
        EXPECT_EQ(counts.total(), pixels * (depth + depth * 11));
    }
}

/// A hit of a glass ball: one ray is mirrored and lost, one goes in; every hit inside sends one on and one out, which is lost.
TEST(Counts, OfAGlassBallFollowFromDepth) {
    for (const uint depth : {2u, 3u, 6u}) {
        Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0}, 60, 40);
        scene.integrator.max_depth = depth;
        add_sphere(scene, add_material(scene, glass(1.5f)), {0, 0, 0}, 1);
        const RayCounts counts = render_scene(scene).counts;
        std::uint64_t hits = 0;
        for (uint y = 0; y < 40; ++y)
            for (uint x = 0; x < 40; ++x) hits += oracle::cross_sphere(oracle::eye_ray(scene, x, y), Vec(0), 1).has_value();
        EXPECT_EQ(counts.rays[RAY_CAMERA], 40u * 40);
        EXPECT_EQ(counts.hits[RAY_CAMERA], hits);
        EXPECT_EQ(counts.rays[RAY_REFLECTED], hits * (depth - 1));
        EXPECT_EQ(counts.hits[RAY_REFLECTED], hits * (depth - 2));
        EXPECT_EQ(counts.rays[RAY_REFRACTED], hits * (depth - 1));
        EXPECT_EQ(counts.hits[RAY_REFRACTED], hits);
        EXPECT_EQ(counts.rays[RAY_SHADOW], 0u);
    }
}

/// A ball over a floor: which pixels see which, and what the lamp sees, is counted on the host.
TEST(Counts, OfShadowsAreThoseOfTheHost) {
    Scene scene = scene_seen_from({0, 3, 4}, {0, 0, 0}, 50, 64);
    const uint grey = add_material(scene, matte(0.5f));
    add_triangle(scene, grey, {-60, -1, 30}, {60, -1, 30}, {0, -1, -90});
    add_sphere(scene, grey, {0, 0.5f, 0}, 1);
    const Vec lamp(2, 4, 1), center(0, 0.5L, 0);
    scene.lights.push_back(point_light(vec3(lamp), Spectrum(1)));
    const RayCounts counts = render_scene(scene).counts;
    std::uint64_t hits = 0, shadow_rays = 0, shadow_hits = 0;
    for (uint y = 0; y < 64; ++y)
        for (uint x = 0; x < 64; ++x) {
            const Line eye = oracle::eye_ray(scene, x, y);
            const auto ball = oracle::cross_sphere(eye, center, 1);
            if (ball) {
                const Vec p = eye.at(ball->first);
                ++hits, shadow_rays += glm::dot(p - center, lamp - p) > 0;
                continue;
            }
            const Vec p = eye.at(oracle::cross_plane(eye, Vec(0, -1, 0), Vec(0, 1, 0)));
            ASSERT_LT(std::abs(p.x), (p.z + 90) / 2) << "the floor fills the picture's rest";
            ++hits, ++shadow_rays;
            shadow_hits += oracle::cross_sphere({p, glm::normalize(lamp - p)}, center, 1).has_value();
        }
    EXPECT_EQ(counts.hits[RAY_CAMERA], hits);
    EXPECT_EQ(counts.rays[RAY_SHADOW], shadow_rays);
    EXPECT_EQ(counts.hits[RAY_SHADOW], shadow_hits);
    EXPECT_GT(shadow_hits, 50u);
    EXPECT_LT(shadow_rays, hits);
}

/// Items of the kernels' launches are the rays that were counted.
TEST(Counts, OfKernelsItemsAreThoseOfTheRays) {
    for (const bool with_glass : {false, true}) {
        for (const uint batch : {65536u, 700u}) {
            const Scene scene = soup(true, with_glass);
            const Profiled run(scene, batch);
            const RayCounts &counts = run.counts;
            const std::uint64_t traced = counts.rays[RAY_CAMERA] + counts.rays[RAY_REFLECTED] + counts.rays[RAY_REFRACTED];
            EXPECT_EQ(counts.rays[RAY_CAMERA], 50u * 50);
            EXPECT_EQ(run.items("generate_camera_rays"), counts.rays[RAY_CAMERA]);
            std::set<std::string> stages;
            std::uint64_t in_traversals = 0;
            for (const Traversal &traversal : traversals()) stages.insert(traversal.closest_hit);
            for (const std::string &stage : stages) in_traversals += run.items(stage);
            EXPECT_EQ(in_traversals, traced);
            EXPECT_EQ(run.items("evaluate_surfaces"), traced);
            EXPECT_EQ(run.items("shade_whitted"), traced) << "one block of lights";
            EXPECT_EQ(run.items("spawn_shadow_rays"), 3 * traced) << "three lights";
            EXPECT_EQ(run.items("add_samples"), 50u * 50);
            EXPECT_EQ(counts.rays[RAY_REFRACTED] > 0, with_glass);
            for (const auto &[name, kernel] : run.profile) {
                EXPECT_GT(kernel.launches, 0u) << name;
                EXPECT_GT(kernel.milliseconds, 0) << name;
            }
            if (batch == 700) {
                EXPECT_GE(run.profile.at("generate_camera_rays").launches, (50u * 50 + 699) / 700);
            }
        }
    }
}

/// A small picture's samples fill the waves: as many of each pixel as a batch holds. 40 samples in batches of 100 are 11 of each of the 9 pixels,
/// then 16 of each and 13, for which a batch has room in 6 and 7 pixels: two batches each.
TEST(Counts, OfLaunchesAreFewForSmallPictures) {
    Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0}, 60, 3);
    for (const auto &[spp, batch, launches] : {std::array{4096u, 36864u, 1u}, {4096u, 9216u, 4u}, {5000u, 9216u, 5u}, {40u, 100u, 5u}}) {
        scene.film.spp = spp;
        const Profiled run(scene, batch);
        EXPECT_EQ(run.profile.at("generate_camera_rays").launches, launches) << spp << " samples, batch " << batch;
        EXPECT_EQ(run.counts.rays[RAY_CAMERA], 9u * spp);
    }
}

TEST(Counts, OfSamplesCutAreThoseBeyondTheLimit) {
    Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0}, 60, 20);
    add_sphere(scene, add_material(scene, emitter({1, 1e6f, 2})), {0, 0, 0}, 1);
    const Rendering rendering = render_scene(scene);
    EXPECT_EQ(rendering.clamped, rendering.counts.hits[RAY_CAMERA]);
    EXPECT_EQ(rendering.refused, 0u);
    std::uint64_t cut = 0;
    for (const vec3 &pixel : rendering.picture) cut += pixel == vec3(1, 65536, 2);
    EXPECT_EQ(cut, rendering.counts.hits[RAY_CAMERA]);
}

/// A light whose irradiance no float holds: what it brings to a point is left out and counted; the rest of the picture stays.
TEST(Counts, OfContributionsRefusedAreThoseThatAreNotFinite) {
    Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0}, 60, 20);
    scene.background = Spectrum(0.25f);
    add_sphere(scene, add_material(scene, matte(0.5f)), {0, 0, 0}, 1);
    scene.lights.push_back(make_light(PointLight{{0, 3, 3}, Spectrum(3e38f), {1e-5f, 0, 0}}));
    const Rendering rendering = render_scene(scene);
    EXPECT_EQ(rendering.refused, rendering.counts.rays[RAY_SHADOW] - rendering.counts.hits[RAY_SHADOW]);
    EXPECT_GT(rendering.refused, 30u);
    for (const vec3 &pixel : rendering.picture) ASSERT_TRUE(pixel == vec3(0.25f) || pixel == vec3(0)) << pixel.x;
}

/// Finite light is cut, not refused, however bright.
TEST(Counts, OfContributionsRefusedHaveNoneThatAreFinite) {
    Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0}, 60, 20);
    add_sphere(scene, add_material(scene, emitter(Spectrum(3e38f))), {0, 0, 0}, 1);
    const Rendering rendering = render_scene(scene);
    EXPECT_EQ(rendering.refused, 0u);
    EXPECT_EQ(rendering.clamped, rendering.counts.hits[RAY_CAMERA]);
}
