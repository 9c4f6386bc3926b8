/// Fresnel's and Snell's laws, alone and in pictures of glass balls.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "scene/bsdfs/bsdf.h"
#include "tests/images/oracle.h"
#include "tests/images/seen_scenes.h"
#include "tests/support/probe.h"
#include "tests/support/rendering.h"

namespace {

using namespace brandung;
using oracle::Real;
using oracle::Vec;

/// Index, then whether the light comes from the denser side, for probes of Fresnel's law.
struct Interface {
    float cosine, eta;
};

std::vector<Interface> interfaces() {
    std::vector<Interface> list;
    for (const float index : {1.000001f, 1.0001f, 1.01f, 1.1f, 1.33f, 1.5f, 1.7f, 2.0f, 2.417f, 3.0f, 4.0f}) {
        for (const float eta : {index, 1 / index}) {
            std::vector<float> cosines = {0, 1, std::nextafter(1.0f, 0.0f)};
            for (int e = -24; e < 0; ++e) cosines.push_back(std::ldexp(1.0f, e)), cosines.push_back(1 - std::ldexp(1.0f, e));
            for (int i = 1; i < 256; ++i) cosines.push_back(static_cast<float>(i) / 256);
            if (eta > 1) {  // around the critical angle
                float cosine = std::sqrt(1 - 1 / (eta * eta));
                for (int i = 0; i < 20; ++i) cosine = std::nextafter(cosine, 0.0f);
                for (int i = 0; i < 40; ++i) cosines.push_back(cosine = std::nextafter(cosine, 1.0f));
            }
            for (const float cosine : cosines) list.push_back({cosine, eta});
        }
    }
    return list;
}

struct SplitOfLight {
    float cosine_squared_beyond, reflected;
};

std::vector<SplitOfLight> split(const std::vector<Interface> &interfaces) {
    return Probe(R"(#include "kernels/core/refraction.cl"
        typedef struct { float cosine, eta; } Interface;
        typedef struct { float cosine_squared_beyond, reflected; } SplitOfLight;
        kernel void probe(const global Interface *interfaces, global SplitOfLight *splits) {
            const Interface in = interfaces[get_global_id(0)];
            const float beyond = refracted_cosine_squared(in.cosine, in.eta);
            splits[get_global_id(0)] = (SplitOfLight){beyond, fresnel(in.cosine, beyond, in.eta)};
        })")
        .run<SplitOfLight>(interfaces);
}

}  // namespace

/// The error is that of a few products of magnitude up to eta²; so near the critical angle the decision is wrong only within that.
TEST(FresnelsLaw, CosineBeyondIsThatOfSnellsLaw) {
    const std::vector<Interface> all = interfaces();
    const std::vector<SplitOfLight> splits = split(all);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Real eta = all[i].eta, cosine = all[i].cosine, exact = 1 - eta * eta * (1 - cosine * cosine);
        ASSERT_NEAR(splits[i].cosine_squared_beyond, exact, 0x1p-24L * (1 + 4 * eta * eta)) << all[i].cosine << ", " << all[i].eta;
    }
}

/// Reflected light as computed and transmitted light by Fresnel's transmittances for the same two cosines are 1 within 2 ulp.
TEST(FresnelsLaw, ReflectedAndTransmittedLightAddUpToOne) {
    const std::vector<Interface> all = interfaces();
    const std::vector<SplitOfLight> splits = split(all);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const float beyond = splits[i].cosine_squared_beyond;
        const Real transmitted = beyond < 0 ? 0 : 1 - oracle::fresnel(all[i].cosine, std::sqrt(Real(beyond)), all[i].eta, 1);
        ASSERT_NEAR(splits[i].reflected + transmitted, 1, 2 * 0x1p-23L) << all[i].cosine << ", " << all[i].eta;
    }
}

TEST(FresnelsLaw, AtStraightIncidenceIsTheSquareOfTheIndicesRatio) {
    for (const float eta : {1.5f, 1 / 1.5f, 4.0f}) {
        const Real exact = (Real(eta) - 1) * (Real(eta) - 1) / ((Real(eta) + 1) * (Real(eta) + 1));
        EXPECT_NEAR(split({{1, eta}})[0].reflected, exact, 0x1p-24L) << eta;
    }
}

/// F = 1 - a sqrt(cos² beyond) + ...: the step from total reflection to the first float beyond it is no larger than that slope allows.
TEST(FresnelsLaw, IsContinuousAtTheCriticalAngle) {
    for (const float eta : {1.000001f, 1.01f, 1.33f, 1.5f, 2.417f, 4.0f}) {
        const Real critical_squared = 1 - 1 / (Real(eta) * eta);
        std::vector<Interface> around;
        for (int i = -50; i <= 50; ++i) around.push_back({static_cast<float>(std::sqrt(std::max(0.0L, critical_squared + i * 0x1p-25L))), eta});
        const std::vector<SplitOfLight> splits = split(around);
        bool total = false, refracted = false;
        for (std::size_t i = 0; i < splits.size(); ++i) {
            const Real beyond = std::sqrt(std::max(0.0L, Real(splits[i].cosine_squared_beyond)));
            // dF/dcos beyond at 0 is -2 (1 / (eta cos) + eta / cos), for s and p each with weight 1/2.
            const Real slope = 2 * (1 / (Real(eta) * around[i].cosine) + Real(eta) / around[i].cosine);
            ASSERT_GE(splits[i].reflected, 1 - slope * beyond - 2 * 0x1p-23L) << around[i].cosine << ", " << eta;
            ASSERT_LE(splits[i].reflected, 1) << around[i].cosine << ", " << eta;
            total |= splits[i].cosine_squared_beyond<0, refracted |= splits[i].cosine_squared_beyond> 0;
        }
        EXPECT_TRUE(total && refracted) << "both sides were tried, " << eta;
    }
}

/// Equal media have no interface; grazing must not make 0 / 0 of it.
TEST(FresnelsLaw, BetweenEqualMediaIsFiniteAtEveryAngle) {
    std::vector<Interface> all;
    for (const float cosine : {0.0f, 0x1p-149f, 0x1p-126f, 0x1p-24f, 0x1p-12f, 0.1f, 0.5f, 1.0f}) all.push_back({cosine, 1});
    const std::vector<SplitOfLight> splits = split(all);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_TRUE(splits[i].reflected >= 0 && splits[i].reflected <= 1) << all[i].cosine << " gives " << splits[i].reflected;
        EXPECT_TRUE(splits[i].reflected < 1e-12f || all[i].cosine < 0.1f) << all[i].cosine << " gives " << splits[i].reflected;
    }
}

/// A glass ball in an even background of 1. All inner angles are equal, and so F; depth 2 brings F, every further one a part (1 - F)² F^(k - 3)
/// of what is inside: 1 - (1 - F) F^(depth - 2) in all. Nothing is lost and nothing gained.
TEST(Glass, BallInEvenLightGivesBackAllButWhatIsStillInside) {
    for (const float index : {1.5f, 2.417f, 0.8f}) {
        for (const uint depth : {2u, 3u, 4u, 9u}) {
            Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0}, 60, 48);
            scene.integrator.max_depth = depth;
            scene.background = Spectrum(1);
            add_sphere(scene, add_material(scene, glass(index)), {0, 0, 0}, 1);
            const Rendering rendering = render_scene(scene);
            for (uint y = 0; y < 48; ++y)
                for (uint x = 0; x < 48; ++x) {
                    const oracle::Line ray = oracle::eye_ray(scene, x, y);
                    const auto crossings = oracle::cross_sphere(ray, Vec(0), 1);
                    Real expected = 1, cosine = 1;
                    if (crossings) {
                        cosine = -glm::dot(ray.at(crossings->first), ray.direction);
                        const Real f = oracle::fresnel(cosine, 1 / Real(index));
                        expected = f == 1 ? 1 : 1 - (1 - f) * std::pow(f, Real(depth - 2));
                        // Beyond the critical angle of a thinner ball there is no inside to be reached, next to it F is a root.
                        if (index < 1 && std::abs(cosine * cosine - 1 + index * index) < 1e-4L) continue;
                    }
                    // The cosine is off by 1e-6 / cosine; F falls by at most 5 per cosine, and its power a few times faster.
                    ASSERT_NEAR(rendering.picture[y * 48 + x].x, expected, 2e-5L / cosine)
                        << x << ", " << y << ", index " << index << ", depth " << depth;
                }
        }
    }
}

namespace {

/// A glass ball before a floor whose brightness tells the place: light from a lamp close to it, behind the ball as seen from the eye.
struct BallBeforeFloor {
    BallBeforeFloor(float index, bool with_fresnel)
        : index(index), with_fresnel(with_fresnel), scene(scene_seen_from({0.3f, 5, 0.2f}, {0, 0, 0}, 40, 48)) {
        add_floor(scene, add_material(scene, matte(0.5f)), 8, -3);
        Material ball = make_material(Whitted{.transmission = Spectrum(1), .exponent = 1, .fresnel = with_fresnel});
        ball.eta = index;
        add_sphere(scene, add_material(scene, ball), {0, 0, 0}, 1);
        scene.lights.push_back(point_light(vec3(lamp), Spectrum(100)));
    }

    /// Radiance of the floor at p, which the ball does not shadow: the lamp is lower than it.
    Real floor_radiance(const Vec &p) const {
        const Vec way = lamp - p;
        const Real d = glm::length(way);
        return 100 * 0.5L / oracle::pi * (way.y / d) / (d * d);
    }

    /// What the refracted ray of pixel (x, y) brings; nothing where it misses the ball or the floor.
    std::optional<Real> through(uint x, uint y) const {
        const oracle::Line eye = oracle::eye_ray(scene, x, y);
        const auto in = oracle::cross_sphere(eye, Vec(0), 1);
        if (!in || in->second - in->first < 0.3L) return {};
        const Vec p = eye.at(in->first);
        const auto inner_direction = oracle::refract(eye.direction, p, 1 / Real(index));
        if (!inner_direction) return {};
        const oracle::Line inner{p, *inner_direction};
        const Vec q = inner.at(oracle::cross_sphere(inner, Vec(0), 1)->second);
        const auto outer_direction = oracle::refract(inner.direction, -q, Real(index));
        if (!outer_direction || outer_direction->y > -0.2L) return {};
        const oracle::Line outer{q, *outer_direction};
        const Vec end = outer.at(oracle::cross_plane(outer, Vec(0, -3, 0), Vec(0, 1, 0)));
        if (std::abs(end.x) > 7 || std::abs(end.z) > 7) return {};
        const Real f = oracle::fresnel(-glm::dot(eye.direction, p), 1 / Real(index));  // the same where the ray leaves
        return (with_fresnel ? (1 - f) * (1 - f) : 1) * floor_radiance(end);
    }

    const Vec lamp{1.5L, -1.5L, -2.5L};
    float index;
    bool with_fresnel;
    Scene scene;
};

}  // namespace

class GlassBall : public testing::TestWithParam<std::tuple<float, bool>> {};

TEST_P(GlassBall, BendsRaysAsSnellSays) {
    const auto [index, with_fresnel] = GetParam();
    const BallBeforeFloor test(index, with_fresnel);
    const Rendering rendering = render_scene(test.scene);
    std::size_t compared = 0;
    for (uint y = 0; y < 48; ++y)
        for (uint x = 0; x < 48; ++x) {
            const auto expected = test.through(x, y);
            if (!expected) continue;
            ++compared;
            // Each interface bends the error of a direction, 1e-6 at first, by up to 1 / cosine; the lamp is close.
            ASSERT_NEAR(rendering.picture[y * 48 + x].x, *expected, 2e-4L * *expected) << x << ", " << y;
        }
    EXPECT_GT(compared, 300u);
}

INSTANTIATE_TEST_SUITE_P(Glass, GlassBall, testing::Combine(testing::Values(1.0f, 1.33f, 1.5f, 2.0f), testing::Bool()),
                         [](const auto &info) { return "Case" + std::to_string(info.index); });

/// Without Fresnel's law weights do not depend on the angle, but what cannot be refracted is mirrored: an eye below water sees even light as it is,
/// at every angle. The picture of 80 degrees goes beyond the critical angle, of 48.8 degrees, on both sides of its middle.
TEST(Glass, WaterWithoutFresnelsLawMirrorsTotallyWhatItCannotRefract) {
    Scene scene = scene_seen_from({0, -1, 0}, {0, 0, 1}, 80);
    scene.background = Spectrum(1);
    Material water = make_material(Whitted{.reflection = Spectrum(0.25f), .transmission = Spectrum(0.75f), .exponent = 1});
    water.eta = 1.33f;
    add_floor(scene, add_material(scene, water), 1000, 0);
    scene.cameras[0].inside = {scene.materials[0].name};
    const Rendering rendering = render_scene(scene);
    const std::uint64_t hits = rendering.counts.hits[RAY_CAMERA];
    EXPECT_GT(rendering.counts.rays[RAY_REFRACTED], hits / 10) << "some are refracted";
    EXPECT_LT(rendering.counts.rays[RAY_REFRACTED], hits - hits / 10) << "some are not";
    for (const vec3 &pixel : rendering.picture) ASSERT_EQ(pixel, vec3(1));
}
