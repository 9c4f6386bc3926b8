#include "tests/kernels/bsdfs/materials.h"

namespace brandung {

/// What facets reflect onto each other is met within a hundredth, ideal surfaces within a thousandth; what Beckmann's facets do beyond the critical
/// angle is between the places of a table.
const std::vector<TestedMaterial> &tested_materials() {
    static const std::vector<TestedMaterial> all = {
        {"diffuse", R"({"type": "diffuse", "reflectance": [0.2, 0.5, 0.9]})", 0},
        {"diffuse_white", R"({"type": "diffuse", "reflectance": 1})", 0, 1e-3},
        {"phong", R"({"type": "phong", "diffuse": [0.2, 0.5, 0.3], "specular": [0.8, 0.1, 0.4], "exponent": 20})", 0},
        {"phong_sharp", R"({"type": "phong", "diffuse": 0, "specular": 1, "exponent": 2000})", 0.03f},
        {.name = "diffuse_brightened", .text = R"({"type": "diffuse", "reflectance": 0.3})", .width = 0, .white = 1e-3, .diffuse_tint = 5},
        {.name = "phong_brightened",
         .text = R"({"type": "phong", "diffuse": 0.5, "specular": 0.5, "exponent": 20})",
         .width = 0,
         .diffuse_tint = 3,
         .specular_tint = 2},
        {.name = "mirror_brightened",
         .text = R"({"type": "conductor", "eta": 0, "k": 1, "specular": 0.5})",
         .width = 0,
         .white = 1e-3,
         .specular_tint = 4},
        {.name = "metal_02_brightened",
         .text = R"({"type": "conductor", "eta": 0, "k": 1, "roughness": 0.2, "specular": 0.5})",
         .width = 0.04f,
         .white = 1e-2,
         .specular_tint = 4},
        {.name = "plastic_brightened", .text = R"({"type": "plastic", "diffuse": 0.5})", .width = 0, .white = 1e-3, .diffuse_tint = 3},
        {"mirror", R"({"type": "conductor", "eta": 0, "k": 1})", 0, 1e-3},
        {"gold", R"({"type": "conductor", "metal": "gold", "roughness": 0.3})", 0.09f},
        {"copper_beckmann", R"({"type": "conductor", "metal": "copper", "roughness": 0.5, "distribution": "beckmann"})", 0.25f},
        {"metal_005", R"({"type": "conductor", "eta": 0, "k": 1, "roughness": 0.05})", 0.0025f, 1e-2},
        {"metal_02", R"({"type": "conductor", "eta": 0, "k": 1, "roughness": 0.2})", 0.04f, 1e-2},
        {"metal_05", R"({"type": "conductor", "eta": 0, "k": 1, "roughness": 0.5})", 0.25f, 1e-2},
        {"metal_08", R"({"type": "conductor", "eta": 0, "k": 1, "roughness": 0.8})", 0.64f, 1e-2},
        {"metal_1", R"({"type": "conductor", "eta": 0, "k": 1, "roughness": 1})", 1, 1e-2},
        {"metal_005_beckmann", R"({"type": "conductor", "eta": 0, "k": 1, "roughness": 0.05, "distribution": "beckmann"})", 0.0025f, 1e-2},
        {"metal_02_beckmann", R"({"type": "conductor", "eta": 0, "k": 1, "roughness": 0.2, "distribution": "beckmann"})", 0.04f, 1e-2},
        {"metal_05_beckmann", R"({"type": "conductor", "eta": 0, "k": 1, "roughness": 0.5, "distribution": "beckmann"})", 0.25f, 1e-2},
        {"metal_1_beckmann", R"({"type": "conductor", "eta": 0, "k": 1, "roughness": 1, "distribution": "beckmann"})", 1, 1e-2},
        {"plastic", R"({"type": "plastic", "diffuse": [0.1, 0.5, 0.8], "nonlinear": true})", 0},
        {"plastic_white", R"({"type": "plastic", "diffuse": 1})", 0, 1e-3},
        {"plastic_white_nonlinear", R"({"type": "plastic", "diffuse": 1, "nonlinear": true, "eta": 1.9})", 0, 1e-3},
        {"plastic_01", R"({"type": "plastic", "diffuse": 1, "roughness": 0.1})", 0.04f, 1e-2},
        {"plastic_04", R"({"type": "plastic", "diffuse": 1, "roughness": 0.4, "nonlinear": true})", 0.16f, 1e-2},
        {"plastic_1", R"({"type": "plastic", "diffuse": 1, "roughness": 1})", 1, 1e-2},
        {"plastic_03_beckmann", R"({"type": "plastic", "diffuse": 1, "roughness": 0.3, "distribution": "beckmann"})", 0.09f, 1e-2},
        {"plastic_black", R"({"type": "plastic", "diffuse": 0, "roughness": 0.5, "eta": 1.33})", 0.25f},
        {"glass", R"({"type": "dielectric"})", 0, 1e-3, 1 / 1.5f},
        {"glass_from_within", R"({"type": "dielectric"})", 0, 1e-3, 1.5f},
        {"glass_coloured", R"({"type": "dielectric", "reflection": [0.2, 0.5, 1], "transmission": [1, 0.7, 0.3], "roughness": 0.4})", 0, 0, 1 / 1.5f},
        {"glass_04", R"({"type": "dielectric", "roughness": 0.4})", 0, 1e-2, 1 / 1.5f},
        {"glass_04_from_within", R"({"type": "dielectric", "roughness": 0.4})", 0, 1.5e-2, 1.5f},
        {"glass_06", R"({"type": "dielectric", "roughness": 0.6})", 0, 1e-2, 1 / 1.5f},
        {"glass_06_from_within", R"({"type": "dielectric", "roughness": 0.6})", 0, 1.5e-2, 1.5f},
        {"glass_1", R"({"type": "dielectric", "roughness": 1})", 0, 1e-2, 1 / 1.5f},
        {"glass_1_from_within", R"({"type": "dielectric", "roughness": 1})", 0, 1.5e-2, 1.5f},
        {"glass_04_beckmann", R"({"type": "dielectric", "roughness": 0.4, "distribution": "beckmann"})", 0, 1e-2, 1 / 1.5f},
        {"glass_04_beckmann_from_within", R"({"type": "dielectric", "roughness": 0.4, "distribution": "beckmann"})", 0, 1.5e-2, 1.5f},
        {"glass_1_beckmann", R"({"type": "dielectric", "roughness": 1, "distribution": "beckmann"})", 0, 1e-2, 1 / 1.5f},
        {"glass_1_beckmann_from_within", R"({"type": "dielectric", "roughness": 1, "distribution": "beckmann"})", 0, 1.5e-2, 1.5f},
    };
    return all;
}

}  // namespace brandung
