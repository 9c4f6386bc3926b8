/// Where pictures lie on surfaces and around scenes, and what they multiply.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "scene/bsdfs/bsdf.h"
#include "tests/scene/formats/temporary_file.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"

namespace {

using namespace brandung;
using glm::dvec3;
constexpr double pi = std::numbers::pi;

constexpr uint size = 16;  ///< of the film

/// A square picture with a field of view of a right angle, of a scene in which all reflect ambient light of 1.
Scene scene_seen_from(vec3 from, vec3 at) {
    Scene scene;
    scene.file = "textures";
    scene.cameras.push_back({.name = "camera", .from = from, .at = at, .fov = float(pi / 2)});
    scene.film.width = scene.film.height = size;
    scene.ambient = Spectrum(1);
    return scene;
}

uint add_texture(Scene &scene, uint width, uint height, const std::vector<Spectrum> &pixels, TextureWrap wrap = TextureWrap::repeat) {
    scene.textures.push_back({"", {.wrap = wrap}, {width, height, pixels, {}}});
    return uint(scene.textures.size());
}

/// A picture whose red part is u and whose green part is v where it is not near an edge.
uint add_gradient(Scene &scene, TextureWrap wrap = TextureWrap::repeat) {
    constexpr uint width = 64, height = 32;
    std::vector<Spectrum> pixels;
    for (uint row = 0; row < height; ++row)
        for (uint column = 0; column < width; ++column) pixels.push_back({(float(column) + 0.5f) / width, 1 - (float(row) + 0.5f) / height, 0});
    return add_texture(scene, width, height, pixels, wrap);
}

uint add_textured(Scene &scene, uint texture, float reflectance = 1) {
    const Whitted whitted = {.ambient = Spectrum(reflectance), .diffuse = Spectrum(reflectance), .exponent = 1};
    Material material = make_material(whitted);
    material.diffuse_texture = texture;
    return add_material(scene, material);
}

/// Two triangles that fill the picture of a camera at (0, 0, 1) that looks along -z; u and v grow to the right and upwards.
MeshData square() {
    MeshData mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

/// Unit direction of the ray through the middle of a pixel, for a camera that looks along -z.
dvec3 direction_of(uint x, uint y) { return glm::normalize(dvec3((2 * x + 1.0) / size - 1, 1 - (2 * y + 1.0) / size, -1)); }

/// Expects `place(x, y)`, or nothing where it has none, as red and green part of every pixel; half floats have 2^-11 of what they are.
template <class Place> void expect_places(const Scene &scene, Place place) {
    const Rendering rendering = render_scene(scene);
    EXPECT_EQ(rendering.refused, 0u);
    uint seen = 0;
    for (uint y = 0; y < size; ++y)
        for (uint x = 0; x < size; ++x) {
            const std::optional<glm::dvec2> expected = place(x, y);
            if (!expected) continue;
            ++seen;
            const vec3 color = rendering.picture[y * size + x];
            ASSERT_NEAR(color.x, expected->x, 1e-3) << "u at pixel " << x << ", " << y;
            ASSERT_NEAR(color.y, expected->y, 1e-3) << "v at pixel " << x << ", " << y;
        }
    EXPECT_GT(seen, 40u);
}

}  // namespace

TEST(Textures, APictureOnASquareThatFillsTheFilmIsSeenAsItIs) {
    Scene scene = scene_seen_from({0, 0, 1}, {0, 0, 0});
    std::vector<Spectrum> pixels;  // numbers that half floats hold
    for (uint i = 0; i < size * size; ++i) pixels.push_back({float(i) / 256, float(i % 7) / 8, float(i % 3)});
    add_triangle_mesh(scene, add_textured(scene, add_texture(scene, size, size, pixels)), square());
    const Rendering rendering = render_scene(scene);
    for (uint i = 0; i < size * size; ++i)
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(rendering.picture[i][c], pixels[i][c], 1e-4f) << "pixel " << i % size << ", " << i / size;
}

TEST(Textures, SmoothTrianglesHaveTheSameCoordinates) {
    Scene scene = scene_seen_from({0, 0, 1}, {0, 0, 0});
    MeshData mesh = square();
    mesh.normals = std::vector<vec3>(4, vec3(0, 0, 1));
    add_triangle_mesh(scene, add_textured(scene, add_gradient(scene, TextureWrap::clamp)), std::move(mesh));
    expect_places(scene, [](uint x, uint y) { return std::optional(glm::dvec2((x + 0.5) / size, 1 - (y + 0.5) / size)); });
}

// The point p of a sphere of radius 1 about the origin: u = 1/2 + atan2(p.x, p.z) / 2 pi, v = 1 - acos(p.y) / pi.
TEST(Textures, OnSpheresTheMiddleFacesZAndTheTopIsY) {
    Scene scene = scene_seen_from({0, 0, 2}, {0, 0, 0});
    add_sphere(scene, add_textured(scene, add_gradient(scene)), {0, 0, 0}, 1);
    expect_places(scene, [](uint x, uint y) -> std::optional<glm::dvec2> {
        const dvec3 d = direction_of(x, y), eye(0, 0, 2);
        const double b = glm::dot(eye, d), discriminant = b * b - 3;
        if (discriminant < 0.01) return {};
        const dvec3 p = eye + d * (-b - std::sqrt(discriminant));
        return glm::dvec2(0.5 + std::atan2(p.x, p.z) / (2 * pi), 1 - std::acos(p.y) / pi);
    });
}

// A cylinder of radius 1 from y = -4 (v = 0) to y = 4 (v = 1).
TEST(Textures, OnCylindersVGrowsFromTheBaseToTheApex) {
    Scene scene = scene_seen_from({0, 0, 2}, {0, 0, 0});
    add_frustum(scene, add_textured(scene, add_gradient(scene)), {0, -4, 0}, 1, {0, 4, 0}, 1);
    expect_places(scene, [](uint x, uint y) -> std::optional<glm::dvec2> {
        const dvec3 d = direction_of(x, y);
        const double a = d.x * d.x + d.z * d.z, b = 2 * d.z, discriminant = b * b - 3 * a;
        if (discriminant < 0.01) return {};
        const double t = (-b - std::sqrt(discriminant)) / a;
        const dvec3 p = dvec3(0, 0, 2) + d * t;
        return glm::dvec2(0.5 + std::atan2(p.x, p.z) / (2 * pi), 0.5 + p.y / 8);
    });
}

// A disk of radius 1 about the origin, seen from where its normal leads: u turns counterclockwise, as on a cylinder about it; v is the distance.
TEST(Textures, OnDisksVGrowsFromTheCentreToTheRim) {
    Scene scene = scene_seen_from({0, 0, 2}, {0, 0, 0});
    add_disk(scene, add_textured(scene, add_gradient(scene)), {0, 0, 0}, {0, 0, 3}, 1);
    expect_places(scene, [](uint x, uint y) -> std::optional<glm::dvec2> {
        const dvec3 d = direction_of(x, y), p = dvec3(0, 0, 2) - d * (2 / d.z);
        const double distance = std::hypot(p.x, p.y), u = 0.5 + std::atan2(p.x, -p.y) / (2 * pi);
        if (distance < 0.1 || distance > 0.95 || std::abs(u - 0.5) > 0.48) return {};  // where the picture's edges meet
        return glm::dvec2(u, distance);
    });
}

// A sphere and a cylinder, placed in the world by a turn that brings their y axis to -z, by a mirror, and by a stretch along x: the point p of the
// world lies at q in the group's space, whose picture is that of the sphere, or of the cylinder of radius 1 from -1 (v = 0) to 1, there.
TEST(Textures, OfSpheresAndCylindersGoWithTheirInstances) {
    Scene scene = scene_seen_from({0, 0, 3.5f}, {0, 0, 0});
    const uint material = add_textured(scene, add_gradient(scene));
    add_sphere(scene, material, {0, 0, 0}, 1);
    const uint sphere = add_group(scene, "sphere", std::exchange(scene.shapes, {}));
    add_frustum(scene, material, {0, -1, 0}, 1, {0, 1, 0}, 1);
    const uint cylinder = add_group(scene, "cylinder", std::exchange(scene.shapes, {}));
    const AffineMap stretched = then(rotation(-60, {1, 0, 0}), scaling({-2, 1, 1}));
    ASSERT_FALSE(add_instance(scene, sphere, then(stretched, translation({0, 2, 0}))));
    ASSERT_FALSE(add_instance(scene, cylinder, then(stretched, translation({0, -2, 0}))));
    const glm::dmat3 to_group = glm::inverse(stretched.linear);
    expect_places(scene, [&](uint x, uint y) -> std::optional<glm::dvec2> {
        const bool is_sphere = y < size / 2;
        const dvec3 o = to_group * (dvec3(0, 0, 3.5) - dvec3(0, is_sphere ? 2 : -2, 0)), d = to_group * direction_of(x, y);
        const dvec3 across = is_sphere ? dvec3(1) : dvec3(1, 0, 1);
        const double a = glm::dot(d * across, d), b = glm::dot(o * across, d), c = glm::dot(o * across, o) - 1, discriminant = b * b - a * c;
        if (discriminant < 0.02 * a * a) return {};
        dvec3 q = o + d * (-b - std::sqrt(discriminant)) / a;
        if (!is_sphere && std::abs(q.y) > 1) q = o + d * (-b + std::sqrt(discriminant)) / a;  // through the open end
        const double u = 0.5 + std::atan2(q.x, q.z) / (2 * pi), v = is_sphere ? 1 - std::acos(q.y) / pi : 0.5 + q.y / 2;
        if (std::abs(q.y) > 0.95 || std::abs(u - 0.5) > 0.48) return {};  // where the picture's edges meet
        return glm::dvec2(u, v);
    });
}

// Direction d: u = 1/2 + atan2(d.x, -d.z) / 2 pi, v = 1 - acos(d.y) / pi.
TEST(Textures, APanoramasMiddleLiesInMinusZAndItsTopInY) {
    Scene scene = scene_seen_from({1, 2, 3}, {1, 2, 2});
    scene.background = Spectrum(1), scene.background_texture = add_gradient(scene, TextureWrap::panorama);
    const auto place = [](uint x, uint y) {
        const dvec3 d = direction_of(x, y);
        return std::optional(glm::dvec2(0.5 + std::atan2(d.x, -d.z) / (2 * pi), 1 - std::acos(d.y) / pi));
    };
    expect_places(scene, place);
    // Turned by a quarter, the middle lies in -x; and -z shows what lay in x, at u = 3/4.
    scene.background_turn = 0.25f;
    expect_places(scene, [&](uint x, uint y) { return std::optional(*place(x, y) + glm::dvec2(0.25, 0)); });
}

TEST(Textures, MirrorsShowThePanorama) {
    Scene scene = scene_seen_from({0, 0, 1}, {0, 0, 0});
    scene.background = Spectrum(1), scene.background_texture = add_gradient(scene, TextureWrap::panorama);
    scene.background_turn = 0.5f;  // brings the middle to z, where the reflected rays go
    add_triangle_mesh(scene, add_material(scene, mirror(1)), square());
    expect_places(scene, [](uint x, uint y) {
        const dvec3 d = direction_of(x, y);
        return std::optional(glm::dvec2(0.5 + std::atan2(-d.x, -d.z) / (2 * pi), 1 - std::acos(d.y) / pi));
    });
}

TEST(Textures, ColoursOfVerticesAreInterpolatedAndMultiplyPictureAndReflectance) {
    Scene scene = scene_seen_from({0, 0, 1}, {0, 0, 0});
    MeshData mesh = square();
    mesh.colors = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const uint picture = add_texture(scene, 1, 1, {Spectrum(0.5f, 0.25f, 1)});
    add_triangle_mesh(scene, add_textured(scene, picture, 0.5f), std::move(mesh));
    expect_places(scene, [](uint x, uint y) { return std::optional(glm::dvec2(0.25 * (x + 0.5) / size, 0.125 * (1 - (y + 0.5) / size))); });
}

TEST(Textures, APictureOfOneColourIsAFactorOfTheReflectances) {
    const Whitted white = {.ambient = Spectrum(1), .diffuse = Spectrum(1), .specular = Spectrum(1), .exponent = 10};
    Whitted dark = white;
    dark.ambient = dark.diffuse = Spectrum(0.25f), dark.specular = Spectrum(0.5f);
    const auto film_of = [](const Whitted &whitted, bool pictures) {
        Scene scene = scene_seen_from({0, 0, 2}, {0, 0, 0});
        Material material = make_material(whitted);
        if (pictures) {
            material.diffuse_texture = add_texture(scene, 1, 1, {Spectrum(0.25f)});
            material.specular_texture = add_texture(scene, 1, 1, {Spectrum(0.5f)});
        }
        add_sphere(scene, add_material(scene, material), {0, 0, 0}, 1);
        scene.lights.push_back(point_light({2, 2, 3}, Spectrum(20)));
        return film_hash(render_scene(scene).film);
    };
    EXPECT_EQ(film_of(white, true), film_of(dark, false));
    EXPECT_NE(film_of(white, false), film_of(dark, false));
}

/// What scatters diffusely and in a highlight, by a picture that makes 1 of a diffuse reflectance of 0.1, in light of 1 from everywhere.
TEST(Textures, BrighterPicturesThanReflectancesAllowReflectNoMoreThanArrives) {
    Scene scene = read_text(R"({"film": {"width": 16, "height": 16, "spp": 256}, "integrator": {"type": "path"}, "background": 1,
        "camera": {"from": [0, 0, 3], "at": [0, 0, 0], "fov": 10},
        "materials": [{"name": "shiny", "type": "phong", "diffuse": 0.1, "specular": 0.9, "exponent": 50}],
        "objects": [{"type": "sphere", "material": "shiny", "center": [0, 0, 0], "radius": 1}]})");
    const auto mean = [&] {
        vec3 sum(0);
        for (const vec3 &pixel : render_scene(scene).picture) sum += pixel;
        return sum.x / (16 * 16);
    };
    const float plain = mean();
    scene.materials[0].record.diffuse_texture = add_texture(scene, 1, 1, {Spectrum(10)});
    const float brightened = mean();
    EXPECT_LE(plain, 1);
    EXPECT_GT(brightened, plain);
    EXPECT_LE(brightened, 1);
}
