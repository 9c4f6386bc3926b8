/// Records of rays in scenes by hand: what they met and passed, what lit it, and why something did not happen.
#include <gtest/gtest.h>

#include <cmath>

#include "runtime/inspection/reasons.h"
#include "tests/runtime/inspection/inspected.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

/// One pixel, whose ray goes from the origin along -z.
Scene one_ray() {
    Scene scene;
    scene.cameras.push_back({.name = "camera", .from = {0, 0, 0}, .at = {0, 0, -1}});
    scene.film.width = scene.film.height = 1;
    return scene;
}

TracedRay traced(const Scene &scene) { return std::move(inspect(scene, 0, 0, {0, 1}).samples.at(0).ray); }

/// A mirror at z = -4 sends the ray back, past the eye, to a matte wall at z = 8. The wall sees light 0; light 1 is behind it; a ball of radius
/// 1/4 is half way to light 2.
Scene mirror_and_wall() {
    Scene scene = one_ray();
    const uint mirror_material = add_material(scene, mirror(0.5f)), wall = add_material(scene, matte(0.5f));
    add_triangle(scene, mirror_material, {-6, -4, -4}, {6, -4, -4}, {0, 12, -4});
    add_triangle(scene, wall, {-6, -4, 8}, {0, 12, 8}, {6, -4, 8});
    add_sphere(scene, wall, {0, 2, 6.5f}, 0.25f);
    scene.ambient = Spectrum(0.25f);
    scene.lights = {point_light({0, 3, 4}, Spectrum(25)), point_light({0, 0, 10}, Spectrum(1)), point_light({0, 4, 5}, Spectrum(25))};
    return scene;
}

const TracedLight &light(const TracedRay &ray, std::size_t i) { return ray.lights.at(0).lights.at(i); }

/// The mirror's plane is met at a + 3/8 (b - a) + 1/4 (c - a) = (0, 0, -4).
TEST(InspectedRay, OfTheEyeMeetsTheMirror) {
    const TracedRay ray = traced(mirror_and_wall());
    EXPECT_EQ(ray.path.depth, 1u);
    EXPECT_EQ(ray.path.throughput, Spectrum(1));
    EXPECT_EQ(RAY_KIND(ray.ray.tag), RAY_CAMERA);
    EXPECT_EQ(ray.ray.origin, vec3(0));
    EXPECT_EQ(ray.ray.direction, vec3(0, 0, -1));
    EXPECT_EQ(ray.hit.primitive, 0u);
    EXPECT_EQ(ray.hit.t, 4);
    EXPECT_EQ(ray.hit.u, 0.375f);
    EXPECT_EQ(ray.hit.v, 0.25f);
    EXPECT_EQ(ray.description.p, vec3(0, 0, -4));
    EXPECT_EQ(ray.description.geometric, vec3(0, 0, 1));
    EXPECT_EQ(ray.description.normal, vec3(0, 0, 1));
    EXPECT_EQ(ray.description.cosine, 1);
    EXPECT_EQ(ray.unlit, Spectrum(0));
    EXPECT_FALSE(ray.passed_faces());
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(why_not_asked(light(ray, i)), "the material shows no light of lights") << i;
}

/// sqrt(3² + 4²) to light 0, which is at cosine 0.8: 25 / 25 * 0.8 * 0.5 / π; at (0, 4, -3) from the wall, light 2 would give 0.6 * 0.5 / π.
/// Ambient light gives 0.25 * 0.5. The mirror takes half of all.
TEST(InspectedRay, OfTheMirrorMeetsTheWallAndItsLights) {
    const TracedRay eye = traced(mirror_and_wall());
    ASSERT_EQ(eye.children.size(), 1u) << "nothing transmits";
    EXPECT_EQ(eye.children[0].weight, Spectrum(0.5f));
    ASSERT_TRUE(eye.children[0].traced);
    const TracedRay &ray = *eye.children[0].traced;
    EXPECT_EQ(ray.path.depth, 2u);
    EXPECT_EQ(ray.path.throughput, Spectrum(0.5f));
    EXPECT_EQ(RAY_KIND(ray.ray.tag), RAY_REFLECTED);
    EXPECT_EQ(ray.ray.direction, vec3(0, 0, 1));
    EXPECT_EQ(ray.hit.primitive, 1u);
    EXPECT_NEAR(ray.hit.t, 12, 1e-5);
    EXPECT_EQ(ray.description.p, vec3(0, 0, 8));
    EXPECT_EQ(ray.description.geometric, vec3(0, 0, -1));
    EXPECT_EQ(ray.description.emission, Spectrum(0));
    EXPECT_EQ(ray.description.ambient, Spectrum(0.125f));
    EXPECT_EQ(ray.unlit, Spectrum(0.125f));

    EXPECT_TRUE(light(ray, 0).asked && light(ray, 0).visible);
    EXPECT_NEAR(light(ray, 0).ray.direction.y, 0.6, 1e-6);
    EXPECT_NEAR(light(ray, 0).ray.direction.z, -0.8, 1e-6);
    EXPECT_NEAR(light(ray, 0).ray.t_max, 5, 1e-5);
    EXPECT_NEAR(light(ray, 0).radiance.x, 0.4 / M_PI, 1e-6);
    EXPECT_FALSE(light(ray, 1).asked);
    EXPECT_EQ(why_not_asked(light(ray, 1)), "it is behind the surface: its cosine to the shading normal is -1");
    EXPECT_TRUE(light(ray, 2).asked && !light(ray, 2).visible);
    EXPECT_NEAR(light(ray, 2).radiance.x, 0.3 / M_PI, 1e-6);
    EXPECT_EQ(light(ray, 2).blocker.primitive, 2u);
    EXPECT_NEAR(light(ray, 2).blocker.t, 2.25, 1e-5);
    EXPECT_NEAR(ray.lights.at(0).contribution.x, 0.5 * (0.125 + 0.4 / M_PI), 1e-6);
    ASSERT_EQ(ray.children.size(), 1u);
    EXPECT_FALSE(ray.children[0].traced);
}

TEST(InspectedRay, SaysWhyAChildWasNotSpawned) {
    Scene scene = mirror_and_wall();
    const auto why = [&](const TracedRay &ray, uint kind) {
        return why_not_spawned(ray, kind, scene.materials[ray.point.material].record, scene.integrator);
    };
    const TracedRay eye = traced(scene);
    EXPECT_EQ(why(eye, RAY_REFLECTED), "");
    ASSERT_TRUE(eye.children.at(0).traced);
    EXPECT_EQ(why(*eye.children[0].traced, RAY_REFLECTED), "the material does not reflect");

    scene.integrator.threshold = 0.75f;
    EXPECT_EQ(why(traced(scene), RAY_REFLECTED), "its throughput, 0.5, is below integrator.threshold, 0.75");
    scene.integrator.threshold = 0;
    scene.integrator.max_depth = 1;
    const TracedRay last = traced(scene);
    EXPECT_EQ(why(last, RAY_REFLECTED), "depth limit: integrator.max_depth is 1");
    EXPECT_EQ(last.children[0].weight, Spectrum(0.5f)) << "weights are known of those too";
}

/// A pane whose outside is away from the eye is met at 60°: 1.5² sin² 60° is above 1.
TEST(InspectedRay, TellsTotalReflection) {
    Scene scene = one_ray();
    const uint pane = add_material(scene, glass(1.5f));
    const float h = std::sqrt(3.0f) / 2;
    const auto on_pane = [&](float x, float s) { return vec3(x, 0.5f * s, h * s - 4); };
    add_triangle(scene, pane, on_pane(-5, -3), on_pane(0, 3), on_pane(5, -3));
    const auto why = [&](const TracedRay &ray, uint kind) {
        return why_not_spawned(ray, kind, scene.materials[ray.point.material].record, scene.integrator);
    };
    const TracedRay total = traced(scene);
    ASSERT_TRUE(total.hits());
    EXPECT_NEAR(total.description.cosine, 0.5, 1e-6);
    EXPECT_NEAR(total.description.cosine_squared_beyond, 1 - 2.25 * 0.75, 1e-5);
    EXPECT_EQ(total.interface.eta, 1.5f);
    EXPECT_EQ(why(total, RAY_REFLECTED), "");
    EXPECT_EQ(total.children[0].weight, Spectrum(1));
    EXPECT_EQ(why(total, RAY_REFRACTED), "total internal reflection");
}

/// A ball within a ball of the same glass: its faces are no interfaces. The far side of the outer one is met 6 from the near one.
TEST(InspectedRay, PassesFacesThatAreNoInterfaces) {
    Scene scene = one_ray();
    const uint ball = add_material(scene, glass(1.5f));
    add_sphere(scene, ball, {0, 0, -8}, 3);
    add_sphere(scene, ball, {0, 0, -8}, 1);
    const TracedRay eye = traced(scene);
    ASSERT_TRUE(eye.children.at(1).traced);
    const TracedRay &inside = *eye.children[1].traced;
    EXPECT_TRUE(inside.passed_faces());
    ASSERT_EQ(inside.passed.size(), 2u);
    for (const PassedFace &face : inside.passed) EXPECT_EQ(face.hit.primitive, 1u);
    EXPECT_EQ(inside.passed[0].enters, 1u);
    EXPECT_NEAR(inside.passed[0].hit.t, 2, 1e-5) << "from z = -5 to z = -7";
    EXPECT_EQ(inside.passed[1].enters, 0u);
    EXPECT_NEAR(inside.passed[1].hit.t, 4, 1e-5) << "to z = -9";
    EXPECT_NEAR(inside.passed[1].p.z, -9, 1e-5);
    EXPECT_EQ(RAY_SOURCE(inside.ray.tag), 1u);
    EXPECT_NEAR(inside.ray.origin.z, -9, 1e-5);
    EXPECT_EQ(inside.hit.primitive, 0u);
    EXPECT_NEAR(inside.hit.t, 2, 1e-5) << "from z = -9 to z = -11";
    const uint glass_once = 1u << 8 | 1u;
    EXPECT_EQ(inside.before, std::vector<uint>{glass_once});
    EXPECT_EQ(inside.behind, std::vector<uint>{0});
}

/// Balls of radius 1, 0.9, ..., 0.5 about z = -8 in a larger one: the way in and out again, from z = -5 on.
TEST(InspectedRay, ListsAllFacesThatItPasses) {
    Scene scene = one_ray();
    const uint ball = add_material(scene, glass(1.5f));
    add_sphere(scene, ball, {0, 0, -8}, 3);
    for (int i = 0; i < 6; ++i) add_sphere(scene, ball, {0, 0, -8}, 1 - 0.1f * float(i));
    const TracedRay eye = traced(scene);
    ASSERT_TRUE(eye.children.at(1).traced);
    const TracedRay &inside = *eye.children[1].traced;
    ASSERT_EQ(inside.passed.size(), 12u);
    for (uint i = 0; i < 12; ++i) {
        const PassedFace &face = inside.passed[i];
        const uint number = i < 6 ? i : 11 - i;
        const double radius = 1 - 0.1 * number, t = i < 6 ? 3 - radius : 3 + radius;
        EXPECT_EQ(face.hit.primitive, 1 + number) << i;
        EXPECT_EQ(face.enters, uint(i < 6)) << i;
        EXPECT_NEAR(face.hit.t, t, 1e-5) << i;
        EXPECT_NEAR(face.p.z, -5 - t, 1e-5) << i;
        EXPECT_EQ(face.instance, 0u);
    }
}

/// A wall at z = -8, and a light 4 sqrt 2 away at 45 degrees. Panes of glass stand across the way to it, at 1, 1.1, ..., and, if asked for, an opaque
/// ball of radius 1/4 about a point at 3 sqrt 2.
Scene panes_before_light(uint panes, bool blocked, bool filtered) {
    Scene scene = one_ray();
    const uint wall = add_material(scene, matte(0.5f)), clear = add_material(scene, glass(1.5f));
    add_triangle(scene, wall, {-6, -4, -8}, {6, -4, -8}, {0, 12, -8});
    const vec3 forth = glm::normalize(vec3(0, 1, 1)), up = 0.3f * glm::normalize(vec3(0, 1, -1)), right(0.3f, 0, 0);
    for (uint i = 0; i < panes; ++i) {
        const vec3 middle = vec3(0, 0, -8) + (1 + 0.1f * float(i)) * forth;
        add_triangle(scene, clear, middle - up - right, middle - up + right, middle + 2.0f * up);
    }
    if (blocked) add_sphere(scene, wall, {0, 3, -5}, 0.25f);
    scene.lights = {point_light({0, 4, -4}, Spectrum(25))};
    scene.integrator.filtered_shadows = filtered;
    return scene;
}

TEST(InspectedShadow, IsBlockedByWhatIsOpaque) {
    for (const uint panes : {2u, 20u}) {
        const TracedRay ray = traced(panes_before_light(panes, true, true));
        const TracedLight &blocked = light(ray, 0);
        EXPECT_TRUE(blocked.asked && !blocked.visible);
        EXPECT_EQ(blocked.blocker.primitive, 1 + panes);
        EXPECT_NEAR(blocked.blocker.t, 3 * std::sqrt(2) - 0.25, 1e-5);
        ASSERT_EQ(blocked.passed.size(), panes) << "20 are more than are found at once";
        for (uint i = 0; i < panes; ++i) {
            EXPECT_EQ(blocked.passed[i].hit.primitive, 1 + i);
            EXPECT_NEAR(blocked.passed[i].hit.t, 1 + 0.1 * i, 1e-5);
        }
    }
}

/// Panes are met at normal incidence, where Fresnel's reflectance is (0.5 / 2.5)^2.
TEST(InspectedShadow, IsFilteredByTheProductOfItsFaces) {
    const TracedRay ray = traced(panes_before_light(4, false, true));
    const TracedLight &lit = light(ray, 0);
    EXPECT_TRUE(lit.visible);
    ASSERT_EQ(lit.passed.size(), 4u);
    Spectrum product(1);
    for (const PassedFace &face : lit.passed) {
        EXPECT_NEAR(face.transmission.x, 0.96, 1e-5);
        product *= face.transmission;
    }
    EXPECT_TRUE(same_bits(lit.filter.value(), product));
}

TEST(InspectedShadow, IsBlockedByTheClosestWhereItIsNotFiltered) {
    const TracedRay ray = traced(panes_before_light(2, true, false));
    EXPECT_FALSE(light(ray, 0).visible);
    EXPECT_EQ(light(ray, 0).blocker.primitive, 1u);
    EXPECT_NEAR(light(ray, 0).blocker.t, 1, 1e-5);
    EXPECT_TRUE(light(ray, 0).passed.empty());
}

TEST(InspectedShadow, SaysThatASpotLightSendsNothingOutsideItsCone) {
    Scene scene = panes_before_light(0, false, false);
    scene.lights = {spot_light({0, 0, 0}, {0, 0, 1}, Spectrum(25), 30, 0.5), spot_light({0, 0, 0}, {0, 0, -8}, Spectrum(25), 30, 0.5)};
    const TracedRay ray = traced(scene);
    EXPECT_EQ(why_not_asked(light(ray, 0)), "it sends nothing there, as a spot light does outside its cone");
    EXPECT_EQ(light(ray, 0).description.irradiance, Spectrum(0));
    EXPECT_EQ(light(ray, 0).description.cosine, 1);
    EXPECT_TRUE(light(ray, 1).asked);
}

/// A path meets a matte floor at z = -4 and asks the second light, the first being next to nothing: it is 4 above the floor and 3 aside, which gives
/// 25 / 25 * 0.8 * 0.5 / π. It goes on upwards.
TEST(InspectedPath, AsksTheLightThatItChooses) {
    Scene scene = one_ray();
    scene.integrator.type = "path";
    const uint floor = add_material(scene, matte(0.5f));
    add_triangle(scene, floor, {-6, -4, -4}, {6, -4, -4}, {0, 12, -4});
    scene.lights = {point_light({0, 3, 0}, Spectrum(0x1p-40f)), point_light({0, 3, 0}, Spectrum(25))};
    const TracedRay ray = traced(scene);
    const AskedDescription chosen = light(ray, 0).chosen.value();
    EXPECT_TRUE(light(ray, 0).asked && light(ray, 0).visible);
    EXPECT_EQ(light(ray, 0).row, 1u);
    EXPECT_NEAR(chosen.chance, 1, 1e-6);
    EXPECT_EQ(chosen.inverse_density, 0) << "it has no size";
    EXPECT_EQ(chosen.weight, 1) << "so that nothing meets it";
    EXPECT_NEAR(chosen.irradiance.x, 1, 1e-6);
    EXPECT_NEAR(chosen.cosine, 0.8, 1e-6);
    EXPECT_NEAR(chosen.value.x, 0.4 / M_PI, 1e-6);
    EXPECT_NEAR(chosen.pdf, 0.8 / M_PI, 1e-6);
    EXPECT_NEAR(light(ray, 0).radiance.x, 0.4 / M_PI, 1e-6);
    ASSERT_EQ(ray.children.size(), 1u);
    const NextDescription next = ray.children[0].chosen.value();
    EXPECT_EQ(why_not_continued(ray, ray.children[0], scene.integrator), "");
    EXPECT_NEAR(next.pdf, next.ray.direction.z / M_PI, 1e-6);
    EXPECT_NEAR(next.scattered.x, 0.5, 1e-6);
    EXPECT_EQ(next.survival, 1);
    const TracedRay &up = *ray.children[0].traced;
    EXPECT_FALSE(up.hits());
    EXPECT_EQ(up.met->radiance, Spectrum(0));
}

TEST(InspectedPath, SaysWhyALightWasNotAsked) {
    Scene scene = one_ray();
    scene.integrator.type = "path";
    const uint floor = add_material(scene, matte(0.5f));
    add_triangle(scene, floor, {-6, -4, -4}, {6, -4, -4}, {0, 12, -4});
    scene.lights = {point_light({0, 0, -8}, Spectrum(25))};
    EXPECT_EQ(why_not_asked(light(traced(scene), 0)), "it is behind the surface: its cosine to the shading normal is -1");
    scene.lights = {spot_light({0, 0, 0}, {0, 0, 1}, Spectrum(25), 30, 0.5)};
    EXPECT_EQ(why_not_asked(light(traced(scene), 0)), "it sends nothing there, as a spot light does outside its cone");
    scene.materials[floor].record = mirror(0.5f);
    scene.lights = {point_light({0, 3, 0}, Spectrum(25))};
    const TracedRay mirrored = traced(scene);
    EXPECT_EQ(why_not_asked(light(mirrored, 0)), "the material scatters none of it back along the ray");
    EXPECT_TRUE(std::isinf(mirrored.children.at(0).chosen->pdf)) << "a single direction";
}

TEST(InspectedPath, SaysWhyItDoesNotGoOn) {
    Scene scene = mirror_and_wall();
    scene.integrator.type = "path";
    const auto why = [&](const TracedRay &ray) { return why_not_continued(ray, ray.children.at(0), scene.integrator); };
    scene.integrator.max_depth = 1;
    const TracedRay eye = traced(scene);
    EXPECT_EQ(why(eye), "");
    EXPECT_EQ(why(*eye.children[0].traced), "depth limit: integrator.max_depth is 1");
    EXPECT_TRUE(eye.children[0].traced->lights.at(0).lights.empty()) << "where a path ends it asks for nothing";
    scene.materials.at(0).record = scene.materials.at(1).record = matte(0);
    EXPECT_EQ(why(traced(scene)), "the surface sends nothing there");
    scene.materials.at(0).record = scene.materials.at(1).record = matte(0x1p-20f);
    scene.integrator.roulette_depth = 1;
    const TracedRay ended = traced(scene);
    EXPECT_NE(why(ended).find(" is not below the chance to go on, 9.53674e-07; integrator.roulette_depth is 1"), std::string::npos) << why(ended);
}

/// At normal incidence between equal indices Fresnel's reflectance is 0.
TEST(InspectedRay, TellsWeightZero) {
    Scene scene = one_ray();
    const uint ball = add_material(scene, glass(1));
    add_sphere(scene, ball, {0, 0, -8}, 3);
    const TracedRay eye = traced(scene);
    const Material &material = scene.materials[ball].record;
    EXPECT_EQ(eye.children.at(1).weight, Spectrum(1));
    EXPECT_EQ(why_not_spawned(eye, RAY_REFRACTED, material, scene.integrator), "");
    EXPECT_EQ(why_not_spawned(eye, RAY_REFLECTED, material, scene.integrator), "its throughput is 0");
}

}  // namespace
}  // namespace brandung
