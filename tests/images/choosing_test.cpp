/// Materials that choose among others at every hit.
#include <gtest/gtest.h>

#include <functional>
#include <utility>

#include "scene/bsdfs/choosing.h"
#include "scene/kinds.h"
#include "scene/primitives/add.h"
#include "tests/images/irradiance.h"
#include "tests/scene/formats/temporary_file.h"

namespace {

using namespace brandung;
using namespace irradiance;

/// `amount` is the chance of the second, if chance chooses.
uint add_choosing(Scene &scene, const char *kind, uint first, uint second, float amount = 0, uint texture = 0) {
    Material material = make_choosing(choosing_kinds()[kind_number(choosing_kinds(), kind)], {{first, second}, 0, Spectrum(amount)});
    material.diffuse_texture = texture;
    return add_material(scene, material);
}

/// A floor of that material, seen from this height over the origin; white is material 0, a lamp 1, black 2.
Scene floor_seen_from(float height, const std::function<uint(Scene &scene)> &material) {
    Scene scene = scene_seen_at({0.3f, height, 0.2f}, {0, 0, 0});
    scene.film.spp = 64;
    scene.integrator.type = "path", scene.integrator.max_depth = 3;
    add_material(scene, matte(0));
    const uint floor = material(scene);
    add_quad(scene, floor, {-50, 0, 50}, {100, 0, 0}, {0, 0, -100});
    return scene;
}

constexpr uint white = 0, lamp = 1, black = 2;

/// Light from straight above and below, under which white looks as bright as 1.
void light_both_sides(Scene &scene) {
    for (const float side : {-1.0f, 1.0f}) scene.lights.push_back(directional_light({0, side, 0}, Spectrum(float(pi))));
}

}  // namespace

/// Irradiance π on all of a sphere at once; each reflection keeps 0.2 of it with chance 3/4 and 0.8 with chance 1/4, 0.35 in the mean.
TEST(Choosing, AMixReflectsTheMeanAtEveryBounce) {
    for (const uint depth : {1u, 2u, 5u}) {
        Scene scene = scene_seen_at({0.3f, 0.2f, -0.4f}, {-1, 0.5f, 0.7f});
        scene.cameras[0].fov = 1, scene.film.spp = 64;
        scene.integrator.type = "path", scene.integrator.max_depth = depth;
        const uint dark = add_material(scene, matte(0.2f)), bright = add_material(scene, matte(0.8f));
        add_sphere(scene, add_choosing(scene, "mix", dark, bright, 0.25f), {0, 0, 0}, 1);
        scene.lights.push_back(point_light({0, 0, 0}, Spectrum(pi)));
        Real expected = 0, part = 1;
        for (uint bounce = 0; bounce < depth; ++bounce) expected += part *= 0.35L;
        expect_mean(estimate(scene), expected);
    }
}

/// By every integrator, also where an instance has the material, and in a mirror, where the outside stays the outside.
TEST(Choosing, SidesHaveTheirOwnMaterials) {
    const auto sided = [](Scene &scene) { return add_choosing(scene, "two_sided", white, black); };
    for (const char *integrator : {"whitted", "path"})
        for (const bool mirrored : {false, true})
            for (const float height : {1.0f, -1.0f}) {
                Scene scene = floor_seen_from(height, sided);
                scene.integrator.type = integrator;
                light_both_sides(scene);
                if (mirrored) {
                    const uint group = add_group(scene, "floor", std::exchange(scene.shapes, {}));
                    ASSERT_FALSE(add_instance(scene, group, scaling({1, -1, 1}), uint(scene.materials.size() - 1)));
                }
                const Estimate seen = estimate(scene);
                if ((height > 0) == mirrored)
                    EXPECT_EQ(seen.mean, 0) << integrator;
                else
                    expect_mean(seen, 1);
            }
}

TEST(Choosing, WhatAMaskLetsPassIsSeenBehindIt) {
    Scene scene = floor_seen_from(1, [](Scene &) { return lamp; });
    add_quad(scene, add_choosing(scene, "mask", NO_MATERIAL, black, 0.3f), {-50, 0.5f, 50}, {100, 0, 0}, {0, 0, -100});
    expect_mean(estimate(scene), 0.7L);
}

/// Light that is asked ends at the sheet, light that is met counts in full behind it.
TEST(Choosing, AMaskLetsItsPartOfTheLightThrough) {
    Scene scene = scene_seen_at({0.3f, 0.12f, -0.5f}, {0, 0, 0});
    scene.film.spp = 256;
    scene.integrator.type = "path", scene.integrator.max_depth = 3;
    add_material(scene, matte(0));
    add_floor(scene), add_quad(scene, lamp, {-1, 0.5f, -1}, {2, 0.5f, 0}, {0, 0, 1});
    const Estimate open = estimate(scene);
    add_quad(scene, add_choosing(scene, "mask", NO_MATERIAL, black, 0.3f), {-50, 0.2f, 50}, {100, 0, 0}, {0, 0, -100});
    for (const uint light_samples : {1u, 0u}) {
        scene.integrator.light_samples = light_samples;
        const Estimate masked = estimate(scene);
        const double p = statistics::p_of_difference({double(masked.mean), double(masked.variance / Real(masked.samples))},
                                                     {0.7 * double(open.mean), 0.49 * double(open.variance / Real(open.samples))});
        EXPECT_TRUE(statistics::plausible(p)) << masked.mean << " instead of " << 0.7L * open.mean;
        EXPECT_LT(masked.error(), 0.01L * masked.mean) << "the test can tell";
    }
}

/// Under light of 1 from everywhere: half passes, and of what does not the front returns 3/4.
TEST(Choosing, ChoicesNest) {
    const auto nested = [](Scene &scene) {
        const uint front = add_choosing(scene, "mix", white, black, 0.25f);
        return add_choosing(scene, "mask", NO_MATERIAL, add_choosing(scene, "two_sided", front, black), 0.5f);
    };
    for (const float height : {1.0f, -1.0f}) {
        Scene scene = floor_seen_from(height, nested);
        scene.background = Spectrum(1);
        expect_mean(estimate(scene), height > 0 ? 0.875L : 0.5L);
    }
}

/// A material is chosen anew at each hit: of two masks one behind the other the second does not do what the first did.
TEST(Choosing, OneHitDoesNotTellOfAnother) {
    const auto masked = [](Scene &scene) { return add_choosing(scene, "mask", NO_MATERIAL, black, 0.5f); };
    Scene scene = floor_seen_from(1, masked);
    add_quad(scene, uint(scene.materials.size() - 1), {-50, -0.5f, 50}, {100, 0, 0}, {0, 0, -100});
    scene.background = Spectrum(1);
    expect_mean(estimate(scene), 0.25L);
    scene.integrator.max_depth = 1;
    EXPECT_EQ(estimate(scene).mean, 0) << "a hole counts for the depth";
}

TEST(Choosing, PicturesSayTheChancesPointByPoint) {
    for (const float u : {0.25f, 0.5f, 0.75f}) {
        Scene scene = scene_seen_at({u, 1, 0.2f}, {u, 0, 0.2f});
        scene.film.spp = 64;
        scene.integrator.type = "path", scene.integrator.max_depth = 2, scene.background = Spectrum(1);
        add_material(scene, matte(0));
        scene.textures.push_back({"", {}, {2, 1, {Spectrum(0), Spectrum(1)}, {}}});
        MeshData mesh{.positions = {{0, 0, 1}, {1, 0, 1}, {1, 0, 0}, {0, 0, 0}}, .indices = {0, 1, 2, 0, 2, 3}};
        mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        add_triangle_mesh(scene, add_choosing(scene, "mix", black, white, 1, 1), std::move(mesh));
        if (u < 0.5f)
            EXPECT_LT(estimate(scene).mean, 0.002L);
        else
            expect_mean(estimate(scene), 2 * Real(u) - 0.5L);
    }
}

namespace {

/// A floor with a picture, a ball inside one of glass, and a pane under lamps. `wrap` puts these materials into others, of the name "in NAME".
Scene room(const std::string &integrator, bool wrap, const std::string &amounts = "") {
    const bool paths = integrator == "path";
    const std::string materials =
        paths ? R"({"name": "floor", "type": "diffuse", "reflectance": {"texture": ")" BRANDUNG_SOURCE_DIR R"(/scene/examples/tiles.png"}},
                   {"name": "ball", "type": "plastic", "roughness": 0.3}, {"name": "pane", "type": "thin_dielectric"},
                   {"name": "glass", "type": "dielectric"})"
              : R"({"name": "floor", "type": "whitted", "diffuse": {"texture": ")" BRANDUNG_SOURCE_DIR R"(/scene/examples/tiles.png"}},
                   {"name": "ball", "type": "whitted", "diffuse": 0.3, "specular": 0.4, "reflection": 0.3, "eta": 1.4, "fresnel": true},
                   {"name": "pane", "type": "whitted", "reflection": 0.5},
                   {"name": "glass", "type": "whitted", "transmission": 0.8, "reflection": 0.2, "eta": 1.5})";
    const std::string in = wrap ? "in " : "";
    return read_text(R"({"camera": {"from": [0, 1.5, 4], "at": [0, 0.5, 0], "fov": 50}, "background": 0.3, "ambient": 0.1,
        "film": {"width": 48, "height": 36, "spp": 4}, "integrator": {"type": ")" +
                         integrator + R"("}, "materials": [)" + materials + R"(,
        {"name": "lamp", "type": "whitted", "emission": 3}, {"name": "other", "type": "whitted", "diffuse": 0.9, "reflection": 0.1},
        {"name": "in floor", "type": "mix", "first": "floor", "second": "ball", "amount": 0},
        {"name": "in ball", "type": "mix", "first": "pane", "second": "sided ball", "amount": 1},
        {"name": "sided ball", "type": "two_sided", "front": "ball", "back": "pane"},
        {"name": "in pane", "type": ")" +
                         (paths ? R"(mask", "material": "pane", "opacity": 1)" : R"(two_sided", "front": "pane", "back": "pane")") + R"(}],
        "lights": [{"type": "point", "position": [2, 3, 4], "intensity": 30}],
        "objects": [{"type": "polygon", "material": ")" +
                         in + R"(floor", "vertices": [[-9, 0, 9], [9, 0, 9], [9, 0, -9], [-9, 0, -9]], "uvs": [[0, 0], [9, 0], [9, 9], [0, 9]]},
            {"type": "sphere", "material": "glass", "center": [0, 0.7, 0], "radius": 0.7},
            {"type": "sphere", "material": ")" +
                         in + R"(ball", "center": [0, 0.7, 0], "radius": 0.4}, {"type": "sphere", "material": ")" + in +
                         R"(ball", "center": [1.3, 0.5, 0], "radius": 0.5},
            {"type": "polygon", "material": ")" +
                         in + R"(pane", "vertices": [[-2, 0, 1], [-1, 0, 0], [-1, 1, 0], [-2, 1, 1]]},
            {"type": "sphere", "material": "lamp", "center": [-1, 3, 1], "radius": 0.4}]})",
                     amounts.empty() ? std::vector<std::string>() : std::vector<std::string>{amounts});
}

}  // namespace

/// With chances of 0 and 1, and the outside's material where only that is met, the picture is that of the chosen materials: their pictures, indices
/// of refraction in other media, and what inspection tells, are theirs.
TEST(Choosing, WhatIsCertainGivesTheBitsOfTheChosenMaterial) {
    for (const char *integrator : {"whitted", "path"}) {
        const Rendering plain = render_scene(room(integrator, false)), chosen = render_scene(room(integrator, true));
        EXPECT_EQ(film_hash(chosen.film), film_hash(plain.film)) << integrator;
        EXPECT_EQ(chosen.counts.rays, plain.counts.rays) << integrator;
    }
}

TEST(Choosing, BatchesAcceleratorsAndKernelsForEverythingGiveTheSameBits) {
    for (const char *integrator : {"whitted", "path"}) {
        Scene scene = room(integrator, true, "materials.6.amount=0.4");
        const std::uint64_t hash = film_hash(render_scene(scene).film);
        EXPECT_NE(hash, film_hash(render_scene(room(integrator, true)).film));
        for (const uint batch : {1000u, 77u}) EXPECT_EQ(film_hash(render_scene(scene, {.batch = batch}).film), hash) << batch;
        EXPECT_EQ(film_hash(render_scene(scene, {}, Kinds::all).film), hash);
        for (const char *accelerator : {"none", "kd_tree"}) {
            scene.accelerator = accelerator;
            EXPECT_EQ(film_hash(render_scene(scene).film), hash) << accelerator;
        }
    }
}
