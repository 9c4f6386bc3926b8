/// Light through transparent things, where filtered shadows are asked for.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "scene/bsdfs/bsdf.h"
#include "scene/compile.h"
#include "tests/images/oracle.h"
#include "tests/support/probe.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"

namespace {

using namespace brandung;
using oracle::pi;
using oracle::Real;

/// Material 0 is a matte floor of reflectance 1 at y = 0, all that the eye at y = 1 sees; material 1 the glass, above.
Scene floor_under(const Whitted &glass, const Light &light, float eta = 1) {
    Scene scene;
    scene.file = "filtered shadows";
    CameraDescription camera;
    camera.from = {0.3f, 1, 0.5f}, camera.at = {0, 0, 0};
    scene.cameras.push_back(camera);
    scene.film.width = scene.film.height = 24;
    scene.integrator.max_depth = 1, scene.integrator.filtered_shadows = true;
    add_material(scene, matte(1));
    Material material = make_material(glass);
    material.eta = eta;
    add_material(scene, material);
    MeshData mesh;
    append_polygon(scene, mesh, {{-50, 0, 50}, {50, 0, 50}, {50, 0, -50}, {-50, 0, -50}}, {});
    add_triangle_mesh(scene, 0, std::move(mesh));
    scene.lights.push_back(light);
    return scene;
}

/// A pane across the way of all light, whose two triangles meet above what is seen.
void add_pane(Scene &scene, uint material, float height) {
    MeshData mesh;
    append_polygon(scene, mesh, {{-50, height, 50}, {50, height, 50}, {50, height, -50}, {-50, height, -50}}, {});
    add_triangle_mesh(scene, material, std::move(mesh));
}

Light from_above() { return directional_light({0, 1, 0}, Spectrum(pi)); }
const Whitted red{.transmission = {0.5f, 0.25f, 0}, .exponent = 1};

void expect_uniform(const Scene &scene, Spectrum radiance, Real tolerance = 1e-6L) {
    const Rendering rendering = render_scene(scene);
    EXPECT_EQ(rendering.refused, 0u);
    for (const vec3 &pixel : rendering.picture)
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(pixel[c], radiance[c], tolerance) << "colour " << c;
}

}  // namespace

/// Every face counts once; more faces than one list of hits holds.
TEST(FilteredShadows, AreTheTransmissionToThePowerOfTheFaces) {
    for (const uint faces : {1u, 2u, 7u, 8u, 9u, 20u}) {
        Scene scene = floor_under(Whitted{.transmission = {0.9f, 0.5f, 0}, .exponent = 1}, from_above());
        for (uint i = 0; i < faces; ++i) add_pane(scene, 1, 2 + float(i) / 8);
        expect_uniform(scene, Spectrum(std::pow(0.9f, float(faces)), std::pow(0.5f, float(faces)), 0));
    }
}

/// However close to each other: as long as rounding does not hide on which side of one the other is.
TEST(FilteredShadows, CountFacesThatNearlyTouch) {
    for (const float apart : {1.0f, 0.003f, 1e-5f}) {
        Scene scene = floor_under(red, from_above());
        add_pane(scene, 1, 2), add_pane(scene, 1, 2 + apart);
        expect_uniform(scene, {0.25f, 0.0625f, 0});
    }
}

/// A point light below a ceiling: behind more faces than one list holds it is not looked for beyond itself.
TEST(FilteredShadows, EndAtTheLight) {
    Scene scene = floor_under(Whitted{.transmission = Spectrum(0.5f), .exponent = 1}, point_light({0, 4, 0}, Spectrum(pi)));
    const Rendering bare = render_scene(scene);
    for (uint i = 0; i < 10; ++i) add_pane(scene, 1, 2 + float(i) / 8);
    add_pane(scene, 0, 6);
    const Rendering behind = render_scene(scene);
    for (std::size_t i = 0; i < bare.picture.size(); ++i) ASSERT_NEAR(behind.picture[i].x, bare.picture[i].x / 1024, 1e-6f * bare.picture[i].x);
}

/// Panes that are instances of one: each of the ten is met once, though all are the same primitives.
TEST(FilteredShadows, CountFacesOfInstances) {
    Scene scene = floor_under(red, from_above());
    auto world = std::exchange(scene.shapes, {});
    add_pane(scene, 1, 0);
    const uint pane = add_group(scene, "pane", std::exchange(scene.shapes, std::move(world)));
    for (uint i = 0; i < 10; ++i) ASSERT_FALSE(add_instance(scene, pane, translation({0, 2 + i / 8.0, 0})));
    expect_uniform(scene, {std::pow(0.5f, 10.0f), std::pow(0.25f, 10.0f), 0});
}

/// Light falls straight through the edge x = 0 of a pane's triangles upon what the middle column of pixels sees, where x is exactly 0.
TEST(FilteredShadows, CountAFaceOnceAlongTheEdgesOfItsTriangles) {
    Scene scene = floor_under(red, from_above());
    scene.cameras[0].from = {0, 1, 0.5f};
    scene.film.width = scene.film.height = 25;
    MeshData mesh{.positions = {{0, 2, -50}, {0, 2, 50}, {50, 2, 0}, {-50, 2, 0}}, .indices = {0, 1, 2, 1, 0, 3}};
    add_triangle_mesh(scene, 1, std::move(mesh));
    expect_uniform(scene, {0.5f, 0.25f, 0});
}

TEST(FilteredShadows, AreDarkBehindWhatIsOpaque) {
    for (const float height : {1.5f, 2.5f}) {
        Scene scene = floor_under(red, from_above());
        add_pane(scene, 1, 2), add_pane(scene, 0, height);
        expect_uniform(scene, Spectrum(0));
    }
}

TEST(FilteredShadows, AreNotThereUnlessAskedFor) {
    Scene scene = floor_under(red, from_above());
    add_pane(scene, 1, 2);
    scene.integrator.filtered_shadows = false;
    expect_uniform(scene, Spectrum(0));
}

/// A plate lets through (1 - F)² at the angle outside, here 60°.
TEST(FilteredShadows, OfPlatesFollowFresnelsLaw) {
    for (const float eta : {1.5f, 1 / 1.5f}) {
        const Whitted clear{.reflection = Spectrum(1), .transmission = Spectrum(1), .exponent = 1, .fresnel = 1};
        Scene scene = floor_under(clear, directional_light({std::sqrt(3.0f), 1, 0}, Spectrum(pi)), eta);
        add_pane(scene, 1, 2), add_pane(scene, 1, 2.5f);
        const Real passed = 1 - oracle::fresnel(0.5L, 1 / 1.5L);
        expect_uniform(scene, Spectrum(float(0.5L * passed * passed)), 3e-6L);
    }
}

/// What is round is entered and left: a ball, a wall of a cylinder and a ball in an instance, each with a pane inside, twice as many faces as hits.
TEST(FilteredShadows, CountBothFacesOfWhatIsRound) {
    Scene scene = floor_under(Whitted{.transmission = Spectrum(0.5f), .exponent = 1}, from_above());
    add_sphere(scene, 1, {0, 3, 0}, 1);
    add_pane(scene, 1, 3);
    expect_uniform(scene, Spectrum(1 / 8.0f));
    add_frustum(scene, 1, {-9, 7, 0}, 2, {9, 7, 0}, 2);
    add_pane(scene, 1, 7), add_pane(scene, 1, 9.5f);
    expect_uniform(scene, Spectrum(1 / 128.0f));
    auto world = std::exchange(scene.shapes, {});
    add_sphere(scene, 1, {0, 0, 0}, 1);
    const uint ball = add_group(scene, "ball", std::exchange(scene.shapes, std::move(world)));
    for (const double height : {12.0, 15.0}) ASSERT_FALSE(add_instance(scene, ball, translation({0, height, 0})));
    expect_uniform(scene, Spectrum(1 / 2048.0f));
}

/// From the middle of a ball light leaves straight through one face, and loses ((n - 1) / (n + 1))² = 1 / 25.
TEST(FilteredShadows, LetLightOutOfAGlassBall) {
    const Whitted clear{.reflection = Spectrum(1), .transmission = Spectrum(1), .exponent = 1, .fresnel = 1};
    Scene scene = floor_under(clear, point_light({0, 5, 0}, Spectrum(pi)), 1.5f);
    const Rendering bare = render_scene(scene);
    add_sphere(scene, 1, {0, 5, 0}, 1);
    const Rendering behind = render_scene(scene);
    for (std::size_t i = 0; i < bare.picture.size(); ++i) ASSERT_NEAR(behind.picture[i].x, bare.picture[i].x * 0.96f, 1e-6f);
    EXPECT_EQ(behind.counts.hits[RAY_SHADOW], behind.counts.rays[RAY_SHADOW]);
}

TEST(FilteredShadows, AreTheSameForEveryAcceleratorAndBatch) {
    Scene scene = floor_under(Whitted{.diffuse = Spectrum(0.3f), .transmission = {0.9f, 0.7f, 0.8f}, .exponent = 1, .fresnel = 1},
                              point_light({1, 4, 0}, Spectrum(20)), 1.3f);
    scene.integrator.max_depth = 3;
    add_soup(scene, 1, {.of_each = 60, .size = 0.5f}), add_soup(scene, 0, {.of_each = 5, .size = 0.2f, .seed = 2});
    scene.cameras[0].from = {0, 2, 5};
    const std::uint64_t hash = film_hash(render_scene(scene).film);
    EXPECT_EQ(hash, film_hash(render_scene(scene, {.batch = 100}).film));
    scene.accelerator = "none";
    EXPECT_EQ(hash, film_hash(render_scene(scene).film));
    scene.integrator.filtered_shadows = false;
    EXPECT_NE(hash, film_hash(render_scene(scene).film));
}

/// Asked for without need, or needed without being asked for.
TEST(FilteredShadows, AreSkippedWhereThereIsNothingToLookThrough) {
    Scene opaque = floor_under(Whitted{.diffuse = Spectrum(0.5f), .exponent = 1}, from_above());
    add_pane(opaque, 1, 2);
    EXPECT_FALSE(compile(opaque).filters_shadows);
    Scene clear = floor_under(red, from_above());
    add_pane(clear, 1, 2);
    EXPECT_TRUE(compile(clear).filters_shadows);
    for (const Kinds kinds : {Kinds::in_use, Kinds::all}) {
        clear.integrator.type = "path";
        EXPECT_FALSE(compile(clear, {.kinds = kinds}).filters_shadows) << "paths go through glass themselves";
    }
    clear.integrator.type = "whitted";
    clear.integrator.filtered_shadows = false;
    EXPECT_FALSE(compile(clear).filters_shadows);
}

/// Where nobody says how shadows are, where there is something to look through, and where there is light.
TEST(FilteredShadows, AreAdvisedWhereNobodySays) {
    Scene scene = floor_under(red, point_light({0, 5, 0}, Spectrum(1)));
    scene.integrator.filtered_shadows = false, scene.integrator.shadows_unsaid = true;
    EXPECT_TRUE(compile(scene).warnings.empty());
    add_sphere(scene, 1, {3, 5, 0}, 1);
    const auto warnings = compile(scene).warnings;
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings.begin()->first.find("--shadows filtered"), std::string::npos);
    EXPECT_EQ(warnings.begin()->second, 1u);
    scene.integrator.shadows_unsaid = false;
    EXPECT_TRUE(compile(scene).warnings.empty());
    scene.integrator.shadows_unsaid = true;
    scene.lights.clear();
    EXPECT_TRUE(compile(scene).warnings.empty());
}
