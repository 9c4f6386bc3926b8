#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>

#include "kernels/primitives/frustum.h"
#include "kernels/primitives/sphere.h"
#include "scene/bsdfs/bsdf.h"
#include "scene/lights/light.h"
#include "tests/scene/formats/nff_text.h"

namespace brandung {
namespace {

namespace fs = std::filesystem;

template <class View, class Record> View view_of(const Record &record) {
    View view;
    std::memcpy(&view, record.words, sizeof view);
    return view;
}

std::size_t count_of(const Scene &scene, const std::string &kind) {
    std::size_t count = 0;
    for (const auto &shape : scene.shapes) count += shape->kind().name == kind ? shape->count() : 0;
    return count;
}

TEST(Nff, CameraFilmAndIntegrator) {
    const Scene scene = read_nff_text(good_nff);
    ASSERT_EQ(scene.cameras.size(), 1u);
    EXPECT_EQ(scene.cameras[0].from, vec3(1, 2, 3));
    EXPECT_EQ(scene.cameras[0].at, vec3(4, 5, 6));
    EXPECT_EQ(scene.cameras[0].up, vec3(0, 0, 1));
    EXPECT_FLOAT_EQ(scene.cameras[0].fov, std::numbers::pi_v<float> / 2);
    EXPECT_EQ(scene.film.width, 320u);
    EXPECT_EQ(scene.film.height, 200u);
    EXPECT_EQ(scene.integrator.type, "whitted");
    EXPECT_EQ(scene.integrator.max_depth, 5u);
    EXPECT_EQ(scene.background, Spectrum(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(scene.ambient, Spectrum(0));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(Nff, LightsShareTheirPowerAndDoNotFallOff) {
    const Scene scene = read_nff_text(good_nff);
    ASSERT_EQ(scene.lights.size(), 2u);
    const float intensity = std::numbers::pi_v<float> / std::sqrt(2.0f);
    for (int i = 0; i < 2; ++i) {
        EXPECT_STREQ(light_kinds()[scene.lights[i].kind].name, "point");
        const auto light = view_of<PointLight>(scene.lights[i]);
        EXPECT_EQ(light.position, i == 0 ? vec3(1, 2, 3) : vec3(4, 5, 6));
        EXPECT_EQ(light.attenuation, vec3(1, 0, 0));
        EXPECT_FLOAT_EQ(light.intensity.x, intensity);
        EXPECT_FLOAT_EQ(light.intensity.y, intensity * (i == 0 ? 1 : 0.5f));
        EXPECT_FLOAT_EQ(light.intensity.z, intensity * (i == 0 ? 1 : 0.25f));
    }
}

TEST(Nff, MaterialsAreWhitted) {
    const Scene scene = read_nff_text(good_nff);
    ASSERT_EQ(scene.materials.size(), 3u);
    constexpr uint of_bundles = MATERIAL_DIFFUSE | MATERIAL_GLOSSY | MATERIAL_PASSES;
    const Material &matte = scene.materials[0].record, &glass = scene.materials[1].record, &mirror = scene.materials[2].record;
    EXPECT_EQ(view_of<Whitted>(matte).diffuse, Spectrum(0.5f, 0.25f, 0.125f));
    EXPECT_EQ(view_of<Whitted>(matte).ambient, Spectrum(0.5f, 0.25f, 0.125f));
    EXPECT_EQ(view_of<Whitted>(matte).exponent, 10);
    EXPECT_EQ(matte.flags, MATERIAL_LIT | MATERIAL_DIFFUSE);
    EXPECT_EQ(matte.eta, 1);
    const auto view = view_of<Whitted>(glass);
    EXPECT_EQ(view.specular, Spectrum(0.2f));
    EXPECT_EQ(view.reflection, Spectrum(0.2f));
    EXPECT_EQ(view.transmission, Spectrum(0.9f));
    EXPECT_EQ(view.exponent, 30);
    EXPECT_EQ(view.fresnel, 0u);
    EXPECT_EQ(glass.eta, 1.5f);
    EXPECT_EQ(glass.flags & ~of_bundles,
              MATERIAL_REFLECTS | MATERIAL_IDEAL | MATERIAL_TRANSMITS | MATERIAL_SPAWNS_ALWAYS | MATERIAL_LIT | MATERIAL_HIGHLIGHT);
    EXPECT_EQ(mirror.flags & ~of_bundles, MATERIAL_REFLECTS | MATERIAL_IDEAL | MATERIAL_SPAWNS_ALWAYS | MATERIAL_LIT | MATERIAL_HIGHLIGHT);
    // What transmits reflects at weight 0 too.
    const Scene clear = read_nff_text(nff_viewpoint + "f 1 1 1 0 0 0 1 1.5\n");
    EXPECT_EQ(clear.materials[0].record.flags & ~of_bundles, MATERIAL_REFLECTS | MATERIAL_IDEAL | MATERIAL_TRANSMITS | MATERIAL_SPAWNS_ALWAYS);
}

TEST(Nff, ObjectsAreInTheOrderOfTheFile) {
    const Scene scene = read_nff_text(good_nff);
    const std::vector<std::pair<std::string, std::size_t>> expected = {{"triangle", 3}, {"smooth_triangle", 1}, {"sphere", 1},
                                                                       {"frustum", 1},  {"sphere", 1},          {"frustum", 1}};
    ASSERT_EQ(scene.shapes.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(scene.shapes[i]->kind().name, expected[i].first);
        EXPECT_EQ(scene.shapes[i]->count(), expected[i].second);
        EXPECT_EQ(scene.shapes[i]->material, i < 2 ? 0u : i < 5 ? 1u : 2u);
    }
    EXPECT_EQ(scene.shapes[0]->bounds(2).low, vec3(0, 0, 1));
}

TEST(Nff, ObjectsHaveTheNumbersOfTheFile) {
    const Scene scene = read_nff_text(good_nff);
    SphereBlock spheres{};
    scene.shapes[2]->write_lane(0, 0, reinterpret_cast<std::byte *>(&spheres));
    scene.shapes[4]->write_lane(0, 1, reinterpret_cast<std::byte *>(&spheres));
    EXPECT_EQ(vec3(spheres.x[0], spheres.y[0], spheres.z[0]), vec3(1, 2, 3));
    EXPECT_EQ(spheres.radius[0], 0.5f);
    EXPECT_EQ(spheres.radius[1], -0.5f);
    FrustumBlock frusta{};
    scene.shapes[3]->write_lane(0, 0, reinterpret_cast<std::byte *>(&frusta));
    scene.shapes[5]->write_lane(0, 1, reinterpret_cast<std::byte *>(&frusta));
    EXPECT_EQ(frusta.slope[0], -0.25f);
    EXPECT_EQ(frusta.side[0], 1);
    EXPECT_EQ(frusta.slope[1], -0.25f);
    EXPECT_EQ(frusta.side[1], -1);
    SharedTables tables;
    ShadingRecord record{};
    scene.shapes[1]->write_shading(0, record.words, tables);
    EXPECT_EQ(tables.vertex_normals.at(0).b, vec3(0, 0.6f, 0.8f));
}

TEST(Nff, SettingsChangeWhatTheFileSays) {
    const Scene scene = read_nff_text(good_nff, {"film.width=64", "integrator.max_depth=3", "accelerator=none"});
    EXPECT_EQ(scene.film.width, 64u);
    EXPECT_EQ(scene.film.height, 200u);
    EXPECT_EQ(scene.integrator.max_depth, 3u);
    EXPECT_EQ(scene.accelerator, "none");
    EXPECT_NE(error_of_nff_text(good_nff, {"camera.fov=30"}), "");
    EXPECT_NE(error_of_nff_text(good_nff, {"film.widht=30"}), "");
    EXPECT_NE(error_of_nff_text(good_nff, {"film.width=0"}), "");
}

TEST(Nff, WhatStillMakesSenseIsACountedWarning) {
    const Scene scene = read_nff_text(nff_viewpoint +
                                      "l 0 0 9\ns 0 0 0 1\np 3 0 0 0 1 0 0 0 1 0\nf 1 1 1 1 0 0 0 0\ns 0 0 0 0\ns 1 0 0 0\nc 0 0 0 1 0 0 0 1\n"
                                      "p 3 0 0 0 1 1 1 2 2 2\npp 3 0 0 0 0 0 0 1 0 0 0 0 1 0 1 0 0 0 1\n");
    EXPECT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.materials[0].name, "default");
    EXPECT_EQ(scene.shapes.size(), 3u);
    const std::map<std::string, uint> expected = {{"object before any material: grey", 2},
                                                  {"sphere of radius 0: left out", 2},
                                                  {"cone or cylinder without height or radius: left out", 1},
                                                  {"polygon without area: left out", 1},
                                                  {"patch with a normal of length 0: flat", 1}};
    EXPECT_EQ(scene.warnings, expected);
}

/// How often each entity occurs, counted from the file's words alone; "triangles" are the polygons' vertices less two each.
std::map<std::string, std::size_t> recount(const fs::path &file) {
    std::ifstream stream(file);
    std::map<std::string, std::size_t> counts;
    std::string word, previous;
    for (; stream >> word; previous = word) {
        if (std::isalpha(static_cast<unsigned char>(word[0]))) ++counts[word];
        if (previous == "p" || previous == "pp") counts[previous + " triangles"] += std::stoul(word) - 2;
    }
    return counts;
}

TEST(Nff, StandardProceduralDatabases) {
    const std::string data = BRANDUNG_DATA;
    if (data.empty()) GTEST_SKIP() << "BRANDUNG_DATA is not set";
    uint files = 0;
    for (const auto &entry : fs::directory_iterator(data + "/spd")) {
        if (entry.path().extension() != ".nff") continue;
        SCOPED_TRACE(entry.path());
        ++files;
        const Scene scene = read_scene(entry.path().string());
        std::map<std::string, std::size_t> counts = recount(entry.path());
        EXPECT_EQ(count_of(scene, "sphere"), counts["s"]);
        EXPECT_EQ(count_of(scene, "frustum"), counts["c"]);
        EXPECT_EQ(count_of(scene, "triangle"), counts["p triangles"]);
        EXPECT_EQ(count_of(scene, "smooth_triangle"), counts["pp triangles"]);
        EXPECT_EQ(scene.lights.size(), counts["l"]);
        EXPECT_EQ(scene.materials.size(), counts["f"]);
        EXPECT_TRUE(scene.warnings.empty());
        EXPECT_EQ(scene.film.width, 512u);
    }
    EXPECT_EQ(files, 9u);
}

}  // namespace
}  // namespace brandung
