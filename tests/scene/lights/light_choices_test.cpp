#include "scene/lights/light_choices.h"

#include <gtest/gtest.h>

#include "scene/lights/light.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

/// A lamp of power 2 pi, and something to light.
Scene scene_with_lamp() {
    Scene scene = empty_scene();
    scene.integrator.type = "path";
    add_sphere(scene, 0, {10, 0, 0}, 1);
    add_material(scene, emitter(Spectrum(1)));
    add_triangle(scene, 1, {0, 0, 0}, {1, 0, 0}, {0, 2, 0});
    return scene;
}

std::vector<double> chances(const LightChoices &choices) {
    std::vector<double> result;
    for (const LightChoice &choice : choices.choices) result.push_back(1 / double(choice.inverse_chance));
    return result;
}

void add_panorama(Scene &scene) {
    scene.background = Spectrum(2);
    scene.textures.push_back({"", {.wrap = TextureWrap::panorama}, {2, 1, {vec3(1), vec3(1)}, {}}});
    scene.background_texture = 1;
}

}  // namespace

TEST(LightChoices, AreAsLikelyAsLightsArePowerful) {
    Scene scene = scene_with_lamp();
    scene.lights.push_back(point_light({0, 0, 0}, Spectrum(0.5f)));  // again 2 pi
    scene.lights.push_back(point_light({0, 0, 0}, Spectrum(1)));
    const LightChoices choices = make_light_choices(make_light_rows(scene), scene, 1);
    const std::vector<double> all = chances(choices), expected = {0.25, 0.5, 0.25};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(all[i], expected[i], 1e-6);
    EXPECT_NEAR(choices.emission, 0.25, 1e-6);  // area and radiance are 1
    EXPECT_EQ(choices.environment, 0);
}

/// Faces have their own area; of curved shapes the mean of squares counts, which is right where all sides are stretched alike.
TEST(LightChoices, OfInstancesAreByTheirAreaInTheWorld) {
    const auto share_of = [](glm::dvec3 scale, bool round) {
        Scene scene = scene_with_lamp();
        if (round) add_sphere(scene, 1, {0, 0, 0}, 1);
        const std::vector<double> before = chances(make_light_choices(make_light_rows(scene), scene, 1));
        std::vector<std::unique_ptr<Shape>> lamp;
        lamp.push_back(std::move(scene.shapes.back())), scene.shapes.pop_back();
        const uint group = add_group(scene, "lamp", std::move(lamp));
        EXPECT_FALSE(add_instance(scene, group, then(scaling(scale), rotation(40, {1, 2, 3})), NO_MATERIAL));
        scene.lights.push_back(point_light({0, 0, 0}, Spectrum(0.5f)));  // 2 pi
        const std::vector<double> all = chances(make_light_choices(make_light_rows(scene), scene, 1));
        return all.back() / all.front();  // of the lamp over that of the point light
    };
    EXPECT_NEAR(share_of({1, 1, 1}, false), 1, 1e-6);
    EXPECT_NEAR(share_of({100, 100, 100}, false), 1e4, 1e-2);
    EXPECT_NEAR(share_of({-3, 0.5, 7}, false), 1.5, 1e-6);
    EXPECT_NEAR(share_of({0.01, 0.01, -0.01}, true), 4e-4 * M_PI, 1e-9);
    const double squares = (0.25 * 49 + 9 * 49 + 9 * 0.25) / 3;
    EXPECT_NEAR(share_of({-3, 0.5, 7}, true), 4 * M_PI * std::sqrt(squares), 1e-4);
}

/// The directional light's power is pi r² times its irradiance.
TEST(LightChoices, OfWhatIsFarAreAtMostHalfWhereSomethingIsNear) {
    Scene scene = scene_with_lamp();
    scene.lights.push_back(directional_light({0, 0, 1}, Spectrum(1)));
    const LightRows rows = make_light_rows(scene);
    const std::vector<double> small = chances(make_light_choices(rows, scene, 1)), large = chances(make_light_choices(rows, scene, 100));
    EXPECT_NEAR(small[0], 1 / 3.0, 1e-6);
    EXPECT_NEAR(large[0], 0.5, 1e-6);
    EXPECT_NEAR(large[1], 0.5, 1e-6);

    // Two of them share the half by their powers: here 2 * 4 pi² r² of the background, pi r² * 8 pi of the light.
    scene.lights[0] = directional_light({0, 0, 1}, Spectrum(float(8 * M_PI)));
    add_panorama(scene);
    const LightChoices choices = make_light_choices(make_light_rows(scene), scene, 100);
    const std::vector<double> both = chances(choices), expected = {0.25, 0.5, 0.25};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(both[i], expected[i], 1e-6);
    EXPECT_NEAR(choices.environment, 0.25 / (4 * M_PI), 1e-7);
    EXPECT_NEAR(choices.emission, 0.5, 1e-6);
}

/// Else what rays meet would count less, as if it had been asked.
TEST(LightChoices, OfShapesThatAreNotAskedAreNone) {
    Scene scene = scene_with_lamp();
    scene.lights.push_back(point_light({0, 0, 0}, Spectrum(0.5f)));
    scene.integrator.light_samples = 0;
    const LightChoices choices = make_light_choices(make_light_rows(scene), scene, 1);
    EXPECT_EQ(choices.choices.size(), 1u);
    EXPECT_EQ(choices.emission, 0);
}

TEST(LightChoices, OfWhatIsFarAloneAreAll) {
    Scene scene = empty_scene();
    scene.integrator.type = "path";
    add_sphere(scene, 0, {10, 0, 0}, 1), add_panorama(scene);
    const LightChoices choices = make_light_choices(make_light_rows(scene), scene, 100);
    ASSERT_EQ(choices.choices.size(), 1u);
    EXPECT_NEAR(choices.choices[0].inverse_chance, 1, 1e-6);
    EXPECT_NEAR(choices.environment, 1 / (4 * M_PI), 1e-7);
}

/// Whitted's integrator asks no background; nor do paths that ask for none, or have nothing to light, or a black one.
TEST(LightChoices, HaveTheBackgroundWherePathsAskForIt) {
    Scene scene = empty_scene();
    scene.integrator.type = "path";
    add_sphere(scene, 0, {10, 0, 0}, 1), add_panorama(scene);
    EXPECT_EQ(make_light_rows(scene).counts.at("environment"), 1u);
    scene.integrator.light_samples = 0;
    EXPECT_TRUE(make_light_rows(scene).rows.empty());
    scene.integrator.light_samples = 1, scene.integrator.type = "whitted";
    EXPECT_TRUE(make_light_rows(scene).rows.empty());
    scene.integrator.type = "path", scene.background = Spectrum(0);
    EXPECT_TRUE(make_light_rows(scene).rows.empty());
    scene.background = Spectrum(1), scene.materials[0].record = mirror(1);
    EXPECT_TRUE(make_light_rows(scene).rows.empty());
}

}  // namespace brandung
