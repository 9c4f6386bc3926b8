/// What pictures must not depend on: where a scene lies, how it is turned, mirrored and measured, in which order and in how many parts it is said,
/// and whether it is placed by an instance. One picture is the other's reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "scene/bsdfs/bsdf.h"
#include "scene/lights/light.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"
#include "tests/support/statistics/blocks.h"
#include "tests/support/statistics/significance.h"

namespace {

using namespace brandung;

constexpr uint size = 48;

/// p -> map(p), which multiplies lengths by `scale`.
struct Similarity {
    AffineMap map;
    double scale = 1;
    vec3 point(vec3 p) const { return vec3(map.linear * glm::dvec3(p) + map.offset); }
    vec3 direction(vec3 d) const { return vec3(map.linear * glm::dvec3(d) / scale); }
    float length(float x) const { return float(x * scale); }
};

Similarity scaled_by(double factor) { return {scaling(glm::dvec3(factor)), factor}; }

/// A shape before it is placed: adds itself to a scene where the similarity puts it.
using Thing = std::function<void(Scene &, const Similarity &)>;

Thing sphere(uint material, vec3 center, float radius) {
    return [=](Scene &scene, const Similarity &to) { add_sphere(scene, material, to.point(center), to.length(radius)); };
}
Thing frustum(uint material, vec3 base, float base_radius, vec3 apex, float apex_radius) {
    return [=](Scene &scene, const Similarity &to) {
        add_frustum(scene, material, to.point(base), to.length(base_radius), to.point(apex), to.length(apex_radius));
    };
}
Thing triangle(uint material, vec3 a, vec3 b, vec3 c) {
    return [=](Scene &scene, const Similarity &to) { add_triangle(scene, material, to.point(a), to.point(b), to.point(c)); };
}
Thing smooth_triangle(uint material, vec3 a, vec3 b, vec3 c, vec3 center) {
    return [=](Scene &scene, const Similarity &to) { add_smooth_triangle(scene, material, to.point(a), to.point(b), to.point(c), to.point(center)); };
}

enum : uint { floor_one, matte_one, shiny_one, glass_one, lamp_one };

/// Every kind of thing, opaque and mirroring, over a floor, and two bodies of glass.
std::vector<Thing> things() {
    Random random(21);
    std::vector<Thing> all = {triangle(floor_one, {-8, -1, 8}, {8, -1, 8}, {0, -1, -16}), sphere(glass_one, {0.5f, 0, 1}, 0.4f),
                              frustum(glass_one, {-0.6f, -0.3f, 1}, 0.3f, {-0.4f, 0.4f, 0.9f}, 0.2f)};
    const auto place = [&] { return random.in_cube(1); };
    const auto near = [&](vec3 p) { return p + random.in_cube(0.4f); };
    for (uint i = 0; i < 8; ++i) {
        const uint material = i % 2 ? matte_one : shiny_one;
        const vec3 a = place(), b = near(a), c = near(a), d = place(), e = place(), f = near(e), g = place();
        all.push_back(sphere(material, d, 0.2f));
        all.push_back(triangle(material, a, b, c));
        all.push_back(smooth_triangle(material, e, f, near(e), near(e)));
        all.push_back(frustum(material, g, 0.15f, near(g), i % 3 ? 0.1f : 0.0f));
    }
    return all;
}

/// The camera, materials and lights; without things.
Scene empty_stage(const Similarity &to) {
    Scene scene;
    scene.file = "stage";
    CameraDescription camera;
    camera.from = to.point({0, 0, 4}), camera.at = to.point({0, 0, 0}), camera.up = to.direction({0, 1, 0}), camera.fov = glm::radians(35.0f);
    scene.cameras.push_back(camera);
    scene.film.width = scene.film.height = size;
    scene.background = {0.1f, 0.3f, 0.7f}, scene.ambient = Spectrum(0.05f);
    scene.integrator.filtered_shadows = true;
    scene.accelerator = "wide_bvh";
    add_material(scene, matte(0.5f)), add_material(scene, matte(0.7f));
    add_material(
        scene,
        make_material(Whitted{
            .ambient = Spectrum(0.3f), .diffuse = {0.6f, 0.3f, 0.1f}, .specular = Spectrum(0.4f), .reflection = Spectrum(0.3f), .exponent = 30}));
    add_material(scene, glass(1.5f)), add_material(scene, emitter(Spectrum(4)));
    const float square = float(to.scale * to.scale);
    scene.lights.push_back(point_light(to.point({2, 3, 2}), square * Spectrum(9, 8, 7)));
    scene.lights.push_back(directional_light(to.direction({-1, 1, 0.5f}), {0.5f, 0.6f, 0.9f}));
    scene.lights.push_back(spot_light(to.point({-2, 2, 2}), to.point({0, 0, 0}), square * Spectrum(5, 9, 6), 50, 0.5));
    return scene;
}

Scene stage(const std::vector<Thing> &things, const Similarity &to = {}) {
    Scene scene = empty_stage(to);
    for (const Thing &thing : things) thing(scene, to);
    return scene;
}

/// The same things, as they are about the origin, in a group that one instance places.
Scene instanced_stage(const std::vector<Thing> &things, const Similarity &to) {
    Scene scene = empty_stage(to);
    for (const Thing &thing : things) thing(scene, {});
    const uint group = add_group(scene, "things", std::exchange(scene.shapes, {}));
    EXPECT_FALSE(add_instance(scene, group, to.map));
    return scene;
}

/// With the kernels that suit every scene here.
Rendering render(const Scene &scene) {
    const Rendering rendering = render_scene(scene, {}, Kinds::all);
    EXPECT_EQ(rendering.refused, 0u);
    return rendering;
}

void expect_same_bits(const Rendering &a, const Rendering &b) {
    EXPECT_EQ(film_hash(a.film), film_hash(b.film));
    for (uint kind = 0; kind < RAY_KINDS; ++kind) EXPECT_EQ(a.counts.rays[kind], b.counts.rays[kind]) << kind;
}

/// Rounding moves what a pixel sees by some 1e-6 of the scene, bent and mirrored by some 1e-5: so radiance changes by as little, but where an edge,
/// of a thing or its shadow, lies that near to the middle of a pixel. With 30 things of some 40 pixels' outline each, seen directly, by shadows of
/// three lights, mirrored and bent, there are 1e4 pixels' lengths of edges, of which 1e4 x 48 x 1e-5, some 5 pixels, are that near: at most twice
/// that.
void expect_close(const Rendering &a, const Rendering &b) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.picture.size(); ++i) {
        const vec3 difference = glm::abs(a.picture[i] - b.picture[i]), bound = 2e-3f * (0.05f + glm::abs(a.picture[i]));
        different += glm::any(glm::greaterThan(difference, bound));
    }
    EXPECT_LE(different, 10u) << "of " << a.picture.size();
}

}  // namespace

/// Powers of two round nothing. 2^±20 is 10^±6.
TEST(Metamorphic, PowersOfTwoInScaleAreTheSameBits) {
    const Rendering one = render(stage(things()));
    for (const int exponent : {-20, -7, 1, 20}) {
        SCOPED_TRACE(exponent);
        expect_same_bits(one, render(stage(things(), scaled_by(std::ldexp(1.0, exponent)))));
    }
}

TEST(Metamorphic, AnyScaleIsTheSamePicture) {
    const Rendering one = render(stage(things()));
    for (const double scale : {1e-6, 0.3, 1e6}) {
        SCOPED_TRACE(scale);
        expect_close(one, render(stage(things(), scaled_by(scale))));
    }
}

TEST(Metamorphic, RigidMotionIsTheSamePicture) {
    const Rendering one = render(stage(things()));
    for (const AffineMap &map : {rotation(90, {0, 1, 0}), rotation(37, {1, 2, -1}), then(rotation(-111, {1, 0, 1}), translation({3, -7, 5}))})
        expect_close(one, render(stage(things(), {map})));
}

/// Seen from a place and at an angle at which a pixel's mirror image is another one's middle to the last bit. The outside of a triangle of the same
/// order of corners is on its other side in the mirror, where both sides are alike unless it is of glass.
TEST(Metamorphic, MirroredScenesAreMirroredBits) {
    const auto square_stage = [](const Similarity &to) {
        Scene scene = stage(things(), to);
        scene.cameras[0].fov = glm::radians(90.0f);
        scene.film.width = scene.film.height = 64;
        return scene;
    };
    const Rendering one = render(square_stage({})), mirrored = render(square_stage({scaling({-1, 1, 1})}));
    for (uint kind = 0; kind < RAY_KINDS; ++kind) EXPECT_EQ(one.counts.rays[kind], mirrored.counts.rays[kind]) << kind;
    std::size_t different = 0;
    for (std::size_t i = 0; i < one.picture.size(); ++i) different += one.picture[i] != mirrored.picture[i / 64 * 64 + 63 - i % 64];
    EXPECT_EQ(different, 0u);
}

TEST(Metamorphic, TheOrderOfThingsDoesNotMatter) {
    std::vector<Thing> all = things();
    const Rendering one = render(stage(all));
    std::reverse(all.begin(), all.end());
    expect_same_bits(one, render(stage(all)));
    std::rotate(all.begin(), all.begin() + 13, all.end());
    expect_same_bits(one, render(stage(all)));
}

/// A mesh with shared corners, and the same triangles one by one.
TEST(Metamorphic, MeshesAreTheirTriangles) {
    MeshData mesh;
    std::vector<Thing> triangles = things(), with_mesh = triangles;
    for (uint y = 0; y < 5; ++y)
        for (uint x = 0; x < 5; ++x) mesh.positions.push_back({0.4f * float(x) - 0.8f, 0.4f * float(y) - 0.8f, 0.3f * std::sin(float(x * y))});
    for (uint y = 0; y < 4; ++y)
        for (uint x = 0; x < 4; ++x)
            for (const uint index : {5 * y + x, 5 * y + x + 1, 5 * y + x + 6, 5 * y + x, 5 * y + x + 6, 5 * y + x + 5}) mesh.indices.push_back(index);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        triangles.push_back(
            triangle(shiny_one, mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]], mesh.positions[mesh.indices[i + 2]]));
    with_mesh.push_back([&](Scene &scene, const Similarity &) { add_triangle_mesh(scene, shiny_one, mesh); });
    expect_same_bits(render(stage(triangles)), render(stage(with_mesh)));
}

/// A face cut in two at its middle: the halves are the face, but for the seam's rounding.
TEST(Metamorphic, FacesAreTheirHalves) {
    const vec3 a(-1, -0.8f, 0.2f), b(1, -0.6f, -0.1f), c(0.2f, 0.9f, 0.4f), middle = 0.5f * (b + c);
    std::vector<Thing> whole = things(), halves = whole;
    whole.push_back(triangle(shiny_one, a, b, c));
    halves.push_back(triangle(shiny_one, a, b, middle)), halves.push_back(triangle(shiny_one, a, middle, c));
    expect_close(render(stage(whole)), render(stage(halves)));
}

TEST(Metamorphic, InstancesAreWhatTheyPlace) {
    const Similarity placings[] = {{},
                                   {translation({3, -7, 5})},
                                   {rotation(90, {0, 1, 0})},
                                   {rotation(37, {1, 2, -1})},
                                   {scaling({-1, 1, 1})},
                                   scaled_by(4),
                                   {then(then(rotation(-111, {1, 0, 1}), scaling(glm::dvec3(-0.3))), translation({1, 2, -3})), 0.3}};
    for (const Similarity &to : placings) expect_close(render(stage(things(), to)), render(instanced_stage(things(), to)));
}

/// Lamps are another choice of points when they are turned; so pictures of several samples agree as their errors say.
TEST(Metamorphic, TurnedLampsGiveTheSameLight) {
    std::vector<Thing> lit = things();
    lit.push_back(sphere(lamp_one, {1, 2, 1}, 0.3f));
    lit.push_back(frustum(lamp_one, {-2, 1, 1}, 0.2f, {-1, 1.5f, 1}, 0.3f));
    lit.push_back(triangle(lamp_one, {0, 2, -1}, {1, 2, -1}, {0, 2.5f, 0}));
    const auto blocks_of = [&](const AffineMap &map, uint seed) {
        Scene scene = stage(lit, {map});
        scene.lights.clear();
        scene.film.spp = 8, scene.film.seed = seed;
        return statistics::estimates_of_blocks(render(scene).film, size, {8, 8}, 1);
    };
    const auto one = blocks_of({}, 1);
    for (const AffineMap &map : {rotation(37, {1, 2, -1}), then(rotation(100, {0, 1, 1}), translation({2, 0, 1}))})
        EXPECT_TRUE(statistics::plausible(statistics::p_of_differences(one, blocks_of(map, 2))));
}
