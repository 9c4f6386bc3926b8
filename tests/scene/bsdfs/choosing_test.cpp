/// Materials of scene files that choose among others: what is refused, and what counts as in use.
#include "scene/bsdfs/choosing.h"

#include <gtest/gtest.h>

#include "scene/bsdfs/bsdf.h"
#include "scene/compile.h"
#include "scene/error.h"
#include "scene/kinds.h"
#include "scene/materials_in_use.h"
#include "tests/scene/formats/temporary_file.h"

namespace brandung {
namespace {

/// A sphere of material "m"; plain ones are "a", "b", "glass" and "lamp". `materials` are on lines of their own, from the third on.
std::string text_with(const std::string &materials, const std::string &integrator = "path") {
    return R"({"camera": {"from": [0, 0, 5], "at": [0, 0, 0]}, "integrator": {"type": ")" + integrator +
           R"("}, "objects": [{"type": "sphere", "material": "m", "center": [0, 0, 0], "radius": 1}],
"materials": [{"name": "a", "type": "whitted"}, {"name": "b", "type": "whitted", "reflection": 0.5}, {"name": "glass", "type": "dielectric"}, {"name": "lamp", "type": "diffuse", "emission": 1},
)" + materials +
           "]}";
}

Scene scene_with(const std::string &materials, const std::string &integrator = "path") { return read_text(text_with(materials, integrator)); }

/// Without the file's name.
std::string error_of(const std::string &materials, const std::string &integrator = "path") {
    const TemporaryFile file(text_with(materials, integrator));
    try {
        compile(read_scene(file.path));
    } catch (const SceneError &error) {
        const std::string text = error.what();
        return text.starts_with(file.path) ? text.substr(file.path.size()) : text;
    }
    return {};
}

std::vector<std::string> names_in_use(const Scene &scene) {
    const std::vector<bool> used = materials_in_use(scene);
    std::vector<std::string> names;
    for (std::size_t m = 0; m < used.size(); ++m)
        if (used[m]) names.push_back(scene.materials[m].name);
    return names;
}

/// m0 chooses m1, that m2, and so on: so many.
std::string chain(uint count) {
    std::string text = R"({"name": "m", "type": "mix", "first": "m1", "second": "a"})";
    for (uint i = 1; i < count; ++i)
        text += ",\n{\"name\": \"m" + std::to_string(i) + R"(", "type": "mix", "first": "a", "second": ")" +
                (i + 1 < count ? "m" + std::to_string(i + 1) : "b") + "\"}";
    return text;
}

}  // namespace

TEST(ChoosingMaterials, WhatCannotBeIsRefusedInOneLine) {
    EXPECT_EQ(error_of(R"({"name": "m", "type": "mix", "first": "a", "second": "c"})"),
              ":3: /materials/4/second: must be one of a, b, glass, lamp, m, got \"c\"");
    EXPECT_EQ(error_of(R"({"name": "m", "type": "mix", "first": "a"})"), ":3: /materials/4: \"second\" is missing");
    EXPECT_EQ(error_of(R"({"name": "m", "type": "mix", "first": "a", "second": "b", "amount": 1.5})"),
              ":3: /materials/4/amount: must be at most 1, got 1.5");
    EXPECT_EQ(error_of(R"({"name": "m", "type": "two_sided", "front": "a", "back": "b", "emission": 1})").substr(0, 28),
              ":3: /materials/4/emission: u");
    EXPECT_EQ(
        error_of(R"({"name": "m", "type": "mask", "material": "glass"})"),
        ":3: /materials/4/material: material \"glass\" has an inside, which a material that is one of several cannot; thin_dielectric has none");
    EXPECT_EQ(error_of(R"({"name": "m", "type": "two_sided", "front": "a", "back": "lamp"})"),
              ":3: /materials/4/back: material \"lamp\" shines, which a material that is one of several cannot");
}

TEST(ChoosingMaterials, CirclesAreRefused) {
    EXPECT_EQ(error_of(R"({"name": "m", "type": "mask", "material": "m"})"), ":3: /materials/4: leads back to itself: \"m\" -> \"m\"");
    EXPECT_EQ(error_of("{\"name\": \"n\", \"type\": \"mask\", \"material\": \"m\"},\n"
                       R"({"name": "m", "type": "mix", "first": "a", "second": "n"})"),
              ":3: /materials/4: leads back to itself: \"n\" -> \"m\" -> \"n\"");
}

TEST(ChoosingMaterials, NestFourDeep) {
    EXPECT_EQ(error_of(chain(4)), "");
    EXPECT_EQ(error_of(chain(5)),
              ":3: /materials/4: leads over more than 4 materials that choose among others: \"m\" -> \"m1\" -> \"m2\" -> \"m3\" -> \"m4\"");
}

TEST(ChoosingMaterials, MembersAreInUse) {
    const Scene scene =
        scene_with(R"({"name": "m", "type": "mask", "material": "n"}, {"name": "n", "type": "two_sided", "front": "b", "back": "thin"},
        {"name": "thin", "type": "thin_dielectric"}, {"name": "unused", "type": "mix", "first": "a", "second": "b"})");
    EXPECT_EQ(names_in_use(scene), (std::vector<std::string>{"b", "m", "n", "thin"}));
    const CompiledScene compiled = compile(scene);
    EXPECT_TRUE(compiled.chooses);
    EXPECT_TRUE(compiled.reflects);
    EXPECT_EQ(compiled.bsdfs, (std::vector<uint>{kind_number(bsdf_kinds(), "whitted"), kind_number(bsdf_kinds(), "thin_dielectric"),
                                                 kind_number(bsdf_kinds(), "null")}));
    EXPECT_EQ(compiled.header.materials.count, scene.materials.size() + 1) << "one that lets light pass";
    EXPECT_FALSE(compile(scene_with(R"({"name": "m", "type": "whitted"}, {"name": "unused", "type": "mix", "first": "a", "second": "b"})")).chooses);
}

TEST(ChoosingMaterials, WhittedShowsThemUnlessLightPasses) {
    EXPECT_EQ(error_of(R"({"name": "m", "type": "mix", "first": "a", "second": "b"})", "whitted"), "");
    EXPECT_EQ(error_of(R"({"name": "m", "type": "mix", "first": "a", "second": "thin"},
{"name": "thin", "type": "thin_dielectric"})",
                       "whitted"),
              ":4: /materials/5: integrator whitted cannot show a material of type \"thin_dielectric\"; --integrator path can");
    EXPECT_EQ(error_of(R"({"name": "m", "type": "mask", "material": "a"})", "whitted"),
              ":3: /materials/4: integrator whitted cannot show a material of type \"mask\"; --integrator path can");
}

TEST(ChoosingMaterials, TexturesOfMembersWantCoordinates) {
    const std::string texture = R"({"texture": ")" BRANDUNG_SOURCE_DIR R"(/scene/examples/tiles.png"})";
    for (const std::string &more : {R"(, "amount": )" + texture + R"(}, {"name": "n", "type": "diffuse")",
                                    R"(}, {"name": "n", "type": "diffuse", "reflectance": )" + texture}) {
        Scene scene = scene_with(R"({"name": "m", "type": "mix", "first": "a", "second": "n")" + more + "}");
        EXPECT_EQ(compile(scene).texture_count, 1u);
    }
}

/// Of the material "m", which may choose among others.
uint facets_in_use(const std::string &materials) { return compile(scene_with(materials)).facets; }

/// Kernels have no code for other facets than those that can be met.
TEST(Facets, AreKnownByTheirDistributions) {
    const std::string ggx = R"({"name": "ggx", "type": "conductor", "metal": "gold", "roughness": 0.3})",
                      beckmann = R"({"name": "beckmann", "type": "dielectric", "roughness": 0.3, "distribution": "beckmann"})";
    EXPECT_EQ(facets_in_use(R"({"name": "m", "type": "conductor", "metal": "gold"},)" + ggx), 0u);
    EXPECT_EQ(facets_in_use(R"({"name": "m", "type": "plastic", "roughness": 0.3})"), 1u);
    EXPECT_EQ(facets_in_use(R"({"name": "m", "type": "dielectric", "roughness": 0.3, "distribution": "beckmann"})"), 2u);
    EXPECT_EQ(facets_in_use(ggx + "," + beckmann + R"(,{"name": "m", "type": "mix", "first": "ggx", "second": "b"})"), 1u);
    EXPECT_EQ(facets_in_use(ggx + R"(,{"name": "rough", "type": "plastic", "roughness": 0.3, "distribution": "beckmann"})" +
                            R"(,{"name": "m", "type": "mix", "first": "ggx", "second": "rough"})"),
              3u);
}

}  // namespace brandung
