/// Materials of scene files: what is refused, and what their records say.
#include <gtest/gtest.h>

#include <cstring>

#include "kernels/bsdfs/conductor.h"
#include "kernels/bsdfs/plastic.h"
#include "scene/bsdfs/bsdf.h"
#include "scene/error.h"
#include "scene/kinds.h"
#include "scene/parameters.h"
#include "scene/scene.h"

namespace brandung {
namespace {

Material read(const std::string &text) {
    const Document document = parse_document("material", text);
    const Parameters parameters(document, "");
    Scene scene;
    const Material material = bsdf_kinds()[kind_number(bsdf_kinds(), parameters.text("type"))].read(parameters, scene);
    parameters.expect_all_known();
    return material;
}

std::string error_of(const std::string &text) {
    try {
        read(text);
    } catch (const SceneError &error) {
        return error.what();
    }
    return {};
}

template <class View> View view_of(const Material &material) {
    View view;
    std::memcpy(&view, material.words, sizeof view);
    return view;
}

/// But for those of bundles and facets.
uint flags_of(const std::string &text) {
    return read(text).flags & ~(MATERIAL_DIFFUSE | MATERIAL_GLOSSY | MATERIAL_PASSES | 3 * MATERIAL_FACETS | MATERIAL_LOSES);
}

bool is_ideal(const std::string &text) { return (flags_of(text) & MATERIAL_IDEAL) != 0; }

}  // namespace

/// Of every kind that has one.
TEST(Bsdfs, IndicesWhoseRatiosLeaveFloatsAreRefused) {
    for (const char *type : {"dielectric", "thin_dielectric", "plastic", "whitted"}) {
        const auto error = [&](const std::string &eta) { return error_of(R"({"type": ")" + std::string(type) + R"(", "eta": )" + eta + "}"); };
        const std::string why = " (ratios of indices are squared, which must fit into a float)";
        EXPECT_EQ(error("1e14"), "material:1: /eta: must be from 0.01 to 100, got 1e+14" + why);
        EXPECT_EQ(error("0.0099"), "material:1: /eta: must be from 0.01 to 100, got 0.0099" + why);
        EXPECT_EQ(error("100"), "");
        EXPECT_EQ(error("0.01"), type == std::string("plastic") ? "material:1: /eta: must be above 1" : "");
    }
    EXPECT_EQ(error_of(R"({"type": "conductor", "eta": [1, 2, 1e9], "k": 1})"),
              "material:1: /eta: must be at most 10000, got 1e+09 (its fourth power must fit into a float)");
    EXPECT_EQ(error_of(R"({"type": "conductor", "eta": 10000, "k": 10000})"), "");
}

TEST(Bsdfs, WhatCannotBeIsRefused) {
    EXPECT_EQ(error_of(R"({"type": "conductor", "metal": "gold", "roughness": 1.5})"), "material:1: /roughness: must be from 0 to 1, got 1.5");
    EXPECT_EQ(error_of(R"({"type": "conductor"})"), "material:1: needs either \"metal\", or \"eta\" and \"k\"");
    EXPECT_EQ(error_of(R"({"type": "conductor", "metal": "gold", "eta": 1, "k": 1})"),
              "material:1: /metal: the material has both \"metal\" and \"eta\" or \"k\", but needs only \"metal\", or \"eta\" and \"k\"");
    EXPECT_EQ(error_of(R"({"type": "plastic", "eta": 1})"), "material:1: /eta: must be above 1");
    EXPECT_EQ(error_of(R"({"type": "phong", "diffuse": [0.5, 0.2, 0], "specular": [0.6, 0, 0]})"),
              "material:1: /specular: with the diffuse reflectance more light would leave than arrives: their sum is at most 1");
    for (const char *text :
         {R"({"type": "diffuse", "reflectance": 1.5})", R"({"type": "conductor", "eta": 1})", R"({"type": "conductor", "metal": "lead"})",
          R"({"type": "conductor", "metal": "gold", "distribution": "phong"})", R"({"type": "plastic", "diffuse": 2})",
          R"({"type": "dielectric", "eta": 0})", R"({"type": "dielectric", "transmission": 1.5})", R"({"type": "dielectric", "roughness": -1})",
          R"({"type": "thin_dielectric", "roughness": 0.1})", R"({"type": "null", "transmission": 2})"})
        EXPECT_NE(error_of(text), "") << text;
}

/// Lobes that are one direction are none that light from lights can be seen in.
TEST(Bsdfs, AreLitWhereTheyHaveLobes) {
    EXPECT_EQ(flags_of(R"({"type": "diffuse"})"), MATERIAL_LIT);
    EXPECT_EQ(flags_of(R"({"type": "diffuse", "reflectance": 0})"), 0u);
    EXPECT_EQ(flags_of(R"({"type": "conductor", "metal": "iron"})"), MATERIAL_IDEAL);
    EXPECT_EQ(flags_of(R"({"type": "conductor", "metal": "iron", "roughness": 0.2})"), MATERIAL_LIT);
    EXPECT_EQ(flags_of(R"({"type": "plastic", "diffuse": 0})"), MATERIAL_IDEAL);
    EXPECT_EQ(flags_of(R"({"type": "plastic", "diffuse": 0, "roughness": 0.2})"), MATERIAL_LIT);
    EXPECT_EQ(flags_of(R"({"type": "plastic"})"), MATERIAL_LIT | MATERIAL_IDEAL);
    EXPECT_EQ(flags_of(R"({"type": "phong"})"), MATERIAL_LIT);
}

TEST(Bsdfs, AreIdealWhereTheyMirrorLightOrLetItPassInSingleDirections) {
    for (const char *text : {R"({"type": "conductor", "metal": "gold"})", R"({"type": "plastic"})", R"({"type": "dielectric", "transmission": 0})",
                             R"({"type": "dielectric", "reflection": 0})", R"({"type": "thin_dielectric"})", R"({"type": "null"})",
                             R"({"type": "whitted", "reflection": 0.1})", R"({"type": "whitted", "transmission": 0.1})"})
        EXPECT_TRUE(is_ideal(text)) << text;
    for (const char *text :
         {R"({"type": "conductor", "metal": "gold", "roughness": 0.2})", R"({"type": "plastic", "roughness": 0.2})",
          R"({"type": "dielectric", "roughness": 0.2})", R"({"type": "diffuse"})", R"({"type": "phong"})", R"({"type": "whitted"})",
          R"({"type": "conductor", "metal": "gold", "specular": 0})", R"({"type": "dielectric", "reflection": 0, "transmission": 0})",
          R"({"type": "thin_dielectric", "reflection": 0, "transmission": 0})", R"({"type": "null", "transmission": 0})"})
        EXPECT_FALSE(is_ideal(text)) << text;
}

/// Into which rays go, as long as any light passes; a sheet has none.
TEST(Bsdfs, GlassHasAnInside) {
    EXPECT_EQ(flags_of(R"({"type": "dielectric"})"), MATERIAL_TRANSMITS | MATERIAL_IDEAL);
    EXPECT_EQ(flags_of(R"({"type": "dielectric", "roughness": 0.2})"), MATERIAL_TRANSMITS | MATERIAL_LIT);
    EXPECT_EQ(flags_of(R"({"type": "dielectric", "transmission": 0})"), MATERIAL_IDEAL);
    EXPECT_EQ(flags_of(R"({"type": "thin_dielectric"})"), MATERIAL_IDEAL);
    EXPECT_EQ(flags_of(R"({"type": "null"})"), MATERIAL_IDEAL);
    EXPECT_NE(read(R"({"type": "dielectric", "roughness": 0.2, "reflection": 0, "transmission": 0})").flags & MATERIAL_LOSES, 0u) << "kernels ask";
    EXPECT_EQ(read(R"({"type": "dielectric"})").flags & MATERIAL_LOSES, 0u);
    const Material water = read(R"({"type": "dielectric", "eta": 1.33, "priority": 3})");
    EXPECT_EQ(water.eta, 1.33f);
    EXPECT_EQ(water.priority, 3u);
    EXPECT_EQ(read(R"({"type": "thin_dielectric"})").eta, 1.5f);
}

TEST(Bsdfs, RoughnessIsTheRootOfAlpha) {
    EXPECT_FLOAT_EQ(view_of<Conductor>(read(R"({"type": "conductor", "metal": "gold", "roughness": 0.5})")).alpha, 0.25f);
    EXPECT_EQ(view_of<Conductor>(read(R"({"type": "conductor", "metal": "gold", "roughness": 0.005})")).alpha, 0);
}

/// Of glass, 0.0918 of diffuse light from outside and 0.5964 of that from inside are reflected (Duntley's and Judd's tables).
TEST(Bsdfs, ACoatReflectsDiffuseLightFromWithinAsTablesSay) {
    const Plastic plastic = view_of<Plastic>(read(R"({"type": "plastic", "eta": 1.5})"));
    EXPECT_NEAR(1 / (plastic.scale * M_PI), 1 - 0.0918, 1e-4);
    EXPECT_NEAR(plastic.internal, 0.5964, 1e-4);
}

}  // namespace brandung
