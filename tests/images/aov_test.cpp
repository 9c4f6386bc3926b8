/// AOVs of whole renders.
#include <gtest/gtest.h>

#include "scene/bsdfs/bsdf.h"
#include "scene/cameras/camera.h"
#include "scene/kinds.h"
#include "tests/support/filters.h"
#include "tests/support/probe.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

using Channels = std::map<std::string, PictureChannel>;

/// Renders with all AOVs.
Channels render_aovs(Scene &scene, uint batch = 32768, std::size_t largest_band = std::numeric_limits<std::size_t>::max()) {
    Device &device = test_device();
    scene.film.aovs.clear();
    for (uint kind = 0; kind < aov_kinds().size(); ++kind) scene.film.aovs.push_back(kind);
    const CompiledScene compiled = compile(scene);
    const DeviceScene on_device(device, compiled);
    Film film(device, scene.film);
    Aovs aovs(device, scene, compiled, on_device, scene.cameras[0], batch, largest_band);
    Renderer renderer(device, scene, compiled, on_device, scene.cameras[0], {.batch = batch});
    EXPECT_TRUE(renderer.render(film, {}, &aovs).complete());
    Channels channels;
    for (const PictureChannel &channel : aovs.develop(film)) channels[channel.name] = channel;
    return channels;
}

vec3 at(const Channels &channels, std::size_t pixel, const char *x, const char *y, const char *z) {
    return {channels.at(x).floats.at(pixel), channels.at(y).floats.at(pixel), channels.at(z).floats.at(pixel)};
}

Scene camera_at(vec3 from, uint width, uint height, uint spp) {
    Scene scene;
    scene.cameras.push_back({.name = "camera", .from = from, .at = {0, 0, 0}, .fov = glm::radians(40.0f)});
    scene.film.width = width, scene.film.height = height, scene.film.spp = spp;
    scene.background = {0.25f, 2, 0};
    return scene;
}

constexpr const char *all_integrators[] = {"whitted", "path", "distributed"};

/// A material of another kind than others, where the integrator shows such: paths group hits by their kind.
uint add_of_second_kind(Scene &scene) { return add_material(scene, scene.integrator.type == "whitted" ? mirror(0.5f) : make_null(Spectrum(0.5f))); }

/// What a ray from the eye hits is on the sphere about the origin, the normal leads there from the origin, and its colours are the material's.
void expect_sphere(const Channels &channels, vec3 eye) {
    std::size_t hits = 0;
    for (std::size_t i = 0; i < 33 * 25; ++i) {
        const vec3 normal = at(channels, i, "N.X", "N.Y", "N.Z"), albedo = at(channels, i, "albedo.R", "albedo.G", "albedo.B");
        const vec3 position = at(channels, i, "P.X", "P.Y", "P.Z");
        const float depth = channels.at("depth.Z").floats[i];
        ASSERT_EQ(channels.at("samples").numbers[i], 1u);
        if (std::isinf(depth)) {
            ASSERT_EQ(normal, vec3(0));
            ASSERT_EQ(position, vec3(0));
            ASSERT_EQ(albedo, vec3(0.25f, 1, 0)) << "the background, at most 1";
            ASSERT_EQ(channels.at("primitive").numbers[i], NO_HIT);
            ASSERT_EQ(channels.at("instance").numbers[i], NO_HIT);
            continue;
        }
        ++hits;
        ASSERT_NEAR(glm::length(position), 1.5f, 2e-6f);
        ASSERT_NEAR(glm::length(position - eye), depth, 2e-6f);
        ASSERT_NEAR(glm::length(normal - position / 1.5f), 0, 3e-6f);
        ASSERT_EQ(albedo, vec3(0.75f, 0.25f, 1));
        ASSERT_EQ(channels.at("primitive").numbers[i], 1u);
    }
    // tan asin(1.5 / sqrt 21) = 0.3464 of half a height of 0.3640: a circle of 0.4755 pixels' height in radius, 25 high.
    EXPECT_NEAR(double(hits), M_PI * std::pow(0.3464 / 0.3640 * 12.5, 2), 25);
}

TEST(Aovs, OfASphereFollowFromItsGeometry) {
    const vec3 eye = {1, 2, 4};
    Material material =
        make_material(Whitted{.diffuse = {0.5f, 0.25f, 0.125f}, .specular = Spectrum(0.9f), .reflection = {0.25f, 0, 0.5f}, .exponent = 10});
    material.emission = {0, 0, 0.75f};
    for (const char *integrator : all_integrators) {
        SCOPED_TRACE(integrator);
        Scene scene = camera_at(eye, 33, 25, 1);
        scene.integrator.type = integrator;
        add_triangle(scene, add_of_second_kind(scene), {50, 0, 0}, {51, 0, 0}, {50, 1, 0});  // out of sight: the sphere is number 1
        add_sphere(scene, add_material(scene, material), {0, 0, 0}, 1.5f);
        expect_sphere(render_aovs(scene), eye);
    }
}

/// Batches of two rows, the first and last of which hardly have a ray: what earlier ones recorded must not show.
TEST(Aovs, OfAFisheyeAreNothingOutsideOfItsCircle) {
    Scene scene = camera_at({0, 0, 3}, 60, 40, 1);
    scene.cameras[0].kind = kind_number(camera_kinds(), "fisheye"), scene.cameras[0].fov = glm::radians(180.0f);
    add_sphere(scene, add_material(scene, matte(0.5f)), {0, 0, 0}, 2.9f);
    const Channels channels = render_aovs(scene, 120);
    for (uint i = 0; i < 60 * 40; ++i) {
        if (std::hypot(i % 60 + 0.5 - 30, i / 60 + 0.5 - 20) <= 20) {
            ASSERT_GT(channels.at("albedo.R").floats[i], 0);
            continue;
        }
        ASSERT_EQ(at(channels, i, "albedo.R", "albedo.G", "albedo.B"), vec3(0)) << i;
        ASSERT_EQ(at(channels, i, "N.X", "N.Y", "N.Z"), vec3(0)) << i;
        ASSERT_EQ(channels.at("depth.Z").floats[i], std::numeric_limits<float>::infinity()) << i;
        ASSERT_EQ(channels.at("primitive").numbers[i], NO_HIT) << i;
    }
}

/// Colours of vertices on a wall of reflectance 1/2, and a picture of one colour around the scene, by which its background of (1/4, 2, 0) is
/// multiplied.
TEST(Aovs, AlbedoHasTheColoursOfPicturesAndVertices) {
    Scene scene = camera_at({0, 0, 4}, 8, 4, 1);
    scene.textures.push_back({"", {.wrap = TextureWrap::panorama}, {1, 1, {{0.5f, 0.25f, 1}}, {}}});
    scene.background_texture = 1;
    MeshData wall{.positions = {{0, -50, 0}, {0, 50, 0}, {-50, 0, 0}}, .indices = {0, 1, 2}};
    wall.colors = std::vector<Spectrum>(3, {0.25f, 1, 0.5f});
    add_triangle_mesh(scene, add_material(scene, matte(0.5f)), std::move(wall));
    const Channels channels = render_aovs(scene);
    for (std::size_t i = 0; i < 8 * 4; ++i) {
        const vec3 expected = i % 8 < 4 ? vec3(0.125f, 0.5f, 0.25f) : vec3(0.125f, 0.5f, 0);
        EXPECT_LT(glm::length(at(channels, i, "albedo.R", "albedo.G", "albedo.B") - expected), 1e-6f) << "means with weights that add up to 1";
    }
}

AffineMap moved_by(glm::dvec3 way) { return {glm::dmat3(1), way}; }

/// A ball of the world at x = -2, and of a group at 0, 2 and, out of sight behind that, 2 again: who is hit is known by where.
TEST(Aovs, InstancesAreNumberedInTheirOrderAndTheWorldIsInNone) {
    Scene scene = camera_at({0, 0, 10}, 48, 16, 1);
    const uint material = add_material(scene, matte(0.5f));
    add_sphere(scene, material, {0, 0, 0}, 0.9f);
    const uint group = add_group(scene, "ball", std::exchange(scene.shapes, {}));
    add_sphere(scene, material, {-2, 0, 0}, 0.9f);
    for (const glm::dvec3 way : {glm::dvec3(0, 0, 0), glm::dvec3(2, 0, 0), glm::dvec3(2.2, 0, -1)})
        ASSERT_FALSE(add_instance(scene, group, moved_by(way)));
    for (const uint batch : {32768u, 7u}) {
        const Channels channels = render_aovs(scene, batch);
        std::map<uint, uint> pixels;
        for (std::size_t i = 0; i < 48 * 16; ++i) {
            const uint instance = channels.at("instance").numbers[i], primitive = channels.at("primitive").numbers[i];
            const float x = channels.at("P.X").floats[i];
            ++pixels[instance];
            if (primitive != NO_HIT) {
                ASSERT_EQ(primitive, x < -1 ? 0u : 1u);
                ASSERT_EQ(instance, x < -1 ? NO_HIT : x < 1 ? 0u : channels.at("P.Z").floats[i] < -0.5f ? 2u : 1u);
            } else {
                ASSERT_EQ(instance, NO_HIT);
            }
        }
        // 16 pixels are 7.3 high: a ball has a radius of 2 of them, and so 12 of them.
        EXPECT_GE(pixels[0], 9u);
        EXPECT_GE(pixels[1], 9u);
        EXPECT_GE(pixels[NO_HIT], 600u);
    }
}

TEST(Aovs, OfPixelsThatNoSampleIsOfNumberNothing) {
    Scene scene = camera_at({0, 0, 4}, 3, 2, 1);
    for (uint kind = 0; kind < aov_kinds().size(); ++kind) scene.film.aovs.push_back(kind);
    add_sphere(scene, add_material(scene, matte(0.5f)), {0, 0, 0}, 1);
    const CompiledScene compiled = compile(scene);
    const DeviceScene on_device(test_device(), compiled);
    const Film film(test_device(), scene.film.window());
    const Aovs aovs(test_device(), scene, compiled, on_device, scene.cameras[0], 64);
    uint found = 0;
    for (const PictureChannel &channel : aovs.develop(film)) {
        if (channel.name == "primitive" || channel.name == "instance") {
            ++found;
            EXPECT_EQ(channel.numbers, std::vector<uint>(6, NO_HIT)) << channel.name;
        }
    }
    EXPECT_EQ(found, 2u);
}

/// From within glass its surface is seen from the side away from its outward normal.
TEST(Aovs, NormalsFaceTheEyeInsideGlassToo) {
    Scene scene = camera_at({0.5f, 0.25f, 0.1f}, 8, 8, 1);
    add_sphere(scene, add_material(scene, glass(1.5f)), {0, 0, 0}, 2);
    const Channels channels = render_aovs(scene);
    for (std::size_t i = 0; i < 64; ++i)
        EXPECT_NEAR(glm::length(at(channels, i, "N.X", "N.Y", "N.Z") + at(channels, i, "P.X", "P.Y", "P.Z") / 2.0f), 0, 3e-6f);
}

Scene soup_scene(uint spp, const char *integrator = "whitted") {
    Scene scene = camera_at({0.2f, 0.4f, 3}, 21, 17, spp);
    scene.integrator.type = integrator;
    add_soup(scene, add_material(scene, matte(0.7f)), {.of_each = 20, .size = 0.5f, .seed = 1});
    add_soup(scene, add_material(scene, glass(1.5f)), {.of_each = 5, .size = 0.5f, .seed = 2});
    add_soup(scene, add_of_second_kind(scene), {.of_each = 10, .size = 0.5f, .seed = 3});
    for (int i = 0; i < 9; ++i) scene.lights.push_back(point_light({2, 3, float(i)}, Spectrum(1)));
    return scene;
}

void expect_equal(const Channels &a, const Channels &b) {
    for (const auto &[name, channel] : a) {
        EXPECT_EQ(channel.floats, b.at(name).floats) << name;
        EXPECT_EQ(channel.numbers, b.at(name).numbers) << name;
    }
}

TEST(Aovs, HaveTheSameBitsForEveryBatchAndInBands) {
    for (const char *integrator : all_integrators) {
        SCOPED_TRACE(integrator);
        Scene scene = soup_scene(5, integrator);
        const Channels expected = render_aovs(scene);
        for (const uint batch : {1u, 7u, 333u}) expect_equal(expected, render_aovs(scene, batch));
        expect_equal(expected, render_aovs(scene, 32768, 2 * 21 * sizeof(AovPixel)));
    }
}

/// Of the same rays, of which some pass by a camera that does not see everywhere.
TEST(Aovs, OfFirstHitsAreWhittedsWithEveryIntegrator) {
    for (const char *camera : {"perspective", "fisheye"}) {
        const auto channels_of = [&](const char *integrator) {
            Scene scene = soup_scene(3, integrator);
            scene.cameras[0].kind = kind_number(camera_kinds(), camera);
            return render_aovs(scene);
        };
        const Channels expected = channels_of("whitted");
        for (const char *integrator : {"path", "distributed"}) {
            const Channels found = channels_of(integrator);
            for (const char *name : {"N.X", "N.Y", "N.Z", "P.X", "P.Y", "P.Z", "depth.Z"})
                EXPECT_EQ(found.at(name).floats, expected.at(name).floats) << name << ", " << integrator << ", " << camera;
            for (const char *name : {"primitive", "instance"})
                EXPECT_EQ(found.at(name).numbers, expected.at(name).numbers) << name << ", " << integrator << ", " << camera;
        }
    }
}

void expect_part(const Channels &part, const Channels &whole, const Window &crop, uint width) {
    for (const auto &[name, channel] : part)
        for (uint y = crop.top; y < crop.bottom; ++y)
            for (uint x = crop.left; x < crop.right; ++x) {
                const std::size_t i = (y - crop.top) * crop.width() + x - crop.left, j = y * width + x;
                if (channel.numbers.empty()) {
                    ASSERT_EQ(channel.floats[i], whole.at(name).floats[j]) << name;
                } else {
                    ASSERT_EQ(channel.numbers[i], whole.at(name).numbers[j]) << name;
                }
            }
}

TEST(Aovs, OfACropAreThoseOfTheWhole) {
    for (const char *integrator : all_integrators)
        for (const bool splats : {false, true}) {
            SCOPED_TRACE(integrator);
            Scene scene = soup_scene(2, integrator);
            if (splats) scene.film.filter = filter_number("gaussian"), scene.film.filter_radius = 1.5f, scene.film.splat = true;
            const Channels whole = render_aovs(scene);
            scene.film.crop = Window{4, 3, 17, 11};
            expect_part(render_aovs(scene, 100), whole, *scene.film.crop, 21);
        }
}

/// A wall at z = 0 covers the picture's left half; pixels on its edge have hits and misses.
TEST(Aovs, DepthAndPositionAreMeansOfHitsNormalAndAlbedoOfAllSamples) {
    Scene scene = camera_at({0, 0, 4}, 3, 1, 64);
    scene.background = Spectrum(0);
    add_triangle(scene, add_material(scene, matte(0.5f)), {0, -1000, 0}, {0, 1000, 0}, {-1000, 0, 0});
    const Channels channels = render_aovs(scene);
    // The middle pixel is halved, so that half of its samples hit: of each half of them half lie left of the middle.
    EXPECT_EQ(channels.at("N.Z").floats[1], 0.5f);
    EXPECT_EQ(channels.at("albedo.R").floats[1], 0.25f);
    EXPECT_GE(channels.at("depth.Z").floats[1], 4);
    EXPECT_LT(channels.at("depth.Z").floats[1], 4.6f);
    EXPECT_NEAR(channels.at("P.Z").floats[1], 0, 1e-6f);
    EXPECT_LT(channels.at("P.X").floats[1], -0.1f);
    EXPECT_EQ(channels.at("N.Z").floats[0], 1);
    EXPECT_EQ(channels.at("N.Z").floats[2], 0);
    EXPECT_TRUE(std::isinf(channels.at("depth.Z").floats[2]));
}

/// What shines and does nothing else has its emission as albedo: that picture and the radiance are one, through every filter. Where mitchell is
/// negative both are, next to the bright triangle's edge.
TEST(Aovs, AreFilteredAsRadianceIs) {
    std::vector<std::pair<std::string, bool>> ways = {{"tent", true}, {"gaussian", true}};
    for (const std::string &filter : filter_names()) ways.emplace_back(filter, false);
    for (const auto &[filter, splats] : ways) {
        Scene scene = camera_at({0, 0, 4}, 12, 8, 9);
        scene.film.splat = splats;
        scene.film.filter = filter_number(filter), scene.film.filter_radius = filter_kinds()[scene.film.filter].radius;
        scene.background = {0, 0.25f, 0};
        add_triangle(scene, add_material(scene, emitter({0.75f, 0.5f, 1})), {0.1f, -50, 0}, {0.2f, 50, 0}, {-50, 0, 0});
        const std::vector<vec3> picture = render_scene(scene).picture;
        const Channels channels = render_aovs(scene);
        float darkest = 0;
        for (std::size_t i = 0; i < 12 * 8; ++i) {
            const vec3 albedo = at(channels, i, "albedo.R", "albedo.G", "albedo.B");
            // Rounded once more per sample, by half an ulp of at most 1.3: its weight, and then its value; and both means by their division.
            for (int c = 0; c < 3; ++c) ASSERT_NEAR(albedo[c], picture[i][c], 4 * 0x1p-24f) << filter;
            darkest = std::min(darkest, albedo.x);
        }
        EXPECT_EQ(darkest < 0, filter == "mitchell") << filter;
        if (filter == "mitchell") expect_equal(channels, render_aovs(scene, 7));
    }
}

/// A wall at z = 0 before one at -100, which is seen beside it: signed weights would take means of both far beyond both.
TEST(Aovs, LengthsLieBetweenThoseOfHits) {
    Scene scene = camera_at({0, 0, 4}, 12, 8, 9);
    scene.film.filter = filter_number("mitchell"), scene.film.filter_radius = filter_kinds()[scene.film.filter].radius;
    const uint wall = add_material(scene, matte(0.5f));
    add_triangle(scene, wall, {0.1f, -50, 0}, {0.2f, 50, 0}, {-50, 0, 0});
    add_triangle(scene, wall, {-1000, -1000, -100}, {1000, -1000, -100}, {0, 2000, -100});
    const Channels channels = render_aovs(scene);
    uint mixed = 0;
    for (std::size_t i = 0; i < 12 * 8; ++i) {
        const float z = channels.at("P.Z").floats[i], depth = channels.at("depth.Z").floats[i];
        ASSERT_LE(z, 1e-6f) << "at most rounding of t, which is 4";
        ASSERT_GE(z, -100.001f);
        ASSERT_GE(depth, 4);
        mixed += z < -1 && z > -99;
    }
    EXPECT_GT(mixed, 8u);
}

}  // namespace
}  // namespace brandung
