/// What a scene doesn't use is neither compiled, nor launched, nor allocated.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <regex>
#include <set>
#include <utility>

#include "kernels/bsdfs/loss_table.h"
#include "runtime/accelerators/traversals.h"
#include "runtime/opencl/embedded_kernels.h"
#include "runtime/wavefront/aovs.h"
#include "runtime/wavefront/specialization.h"
#include "scene/accelerators/accelerator.h"
#include "scene/bsdfs/bsdf.h"
#include "scene/bsdfs/choosing.h"
#include "scene/filters/filter.h"
#include "scene/kinds.h"
#include "scene/parameters.h"
#include "tests/runtime/scenes_in_use.h"
#include "tests/support/primitives.h"
#include "tests/support/probe.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

/// The expanded text of every kernel file that renders, without comments.
std::map<std::string, std::string> expanded(const Scene &scene, RayLanes lanes = RayLanes::eight) {
    std::map<std::string, std::string> texts;
    const CompiledScene compiled = compile(scene);
    Sources lists = specialize(compiled, lanes);
    lists["generated/camera.cl"] = "#include \"kernels/cameras/perspective.cl\"\n";  // as for the scene's camera
    const auto renders = [&](const EmbeddedFile &file) {
        return file.text.find("\nkernel void ") != std::string_view::npos && !file.path.starts_with("kernels/selftest/") &&
               !file.path.starts_with("kernels/bench/") &&
               (compiled.accelerator->packets || file.text.find("packet_levels.cl") == std::string_view::npos) &&
               ((compiled.accelerator->interleaved && lanes == RayLanes::eight) ||
                file.text.find("accelerators/interleaved.cl") == std::string_view::npos);
    };
    for (const EmbeddedFile &file : embedded_kernels())
        if (renders(file))
            texts[std::string(file.path)] = std::regex_replace(expand_source(std::string(file.path), lists), std::regex(R"(//[^\n]*)"), "");
    return texts;
}

void expect_absent(const Scene &scene, const std::vector<std::string> &words) {
    const auto texts = expanded(scene);
    EXPECT_GT(texts.size(), 8u);
    for (const auto &[file, text] : texts)
        for (const std::string &word : words) {
            const auto place = std::search(text.begin(), text.end(), word.begin(), word.end(), [](char a, char b) { return std::tolower(a) == b; });
            EXPECT_TRUE(place == text.end()) << file << " has " << word << ": " << std::string(place, place + std::min<long>(60, text.end() - place));
        }
}

void expect_present(const Scene &scene, const std::string &file, const std::string &word) {
    EXPECT_NE(expanded(scene).at(file).find(word), std::string::npos) << word << " in " << file;
}

Material of_text(const std::string &text) {
    const Document document = parse_document("material", text);
    const Parameters parameters(document, "");
    Scene scene;
    return bsdf_kinds()[kind_number(bsdf_kinds(), parameters.text("type"))].read(parameters, scene);
}

/// What only code of one kind of primitive has, in small letters.
std::vector<std::string> marks_of(const std::string &kind) {
    std::string record = kind;
    std::erase(record, '_');
    return {"primitives/" + kind, kind + "_crossing(", kind + "_surface(", kind + "_box(", record + "block"};
}

/// Of every kind of primitive; but smooth triangles may use what flat ones have.
TEST(Absence, ASceneOfOneKindHasNoOtherPrimitivesCode) {
    for (const std::string &kind : names_of_primitive_kinds()) {
        Scene scene = scene_with(matte(0.5f));
        add_soup(scene, 0, {.counts = {{kind, 1}}});
        for (const std::string &other : names_of_primitive_kinds())
            if (kind.find(other) == std::string::npos) expect_absent(scene, marks_of(other));
        expect_present(scene, "kernels/stages/intersect.cl", "primitives/" + kind + "_hit.cl");
        expect_present(everything(), "kernels/stages/intersect.cl", "primitives/" + kind + "_hit.cl");
    }
}

TEST(Absence, LightsOfOtherKindsAreNotThere) {
    expect_absent(spheres_only(matte(0.5f)),
                  {"directional", "spot_", "emissive_mesh", "emissive_sphere", "emissive_frustum", "emissive_disk", "stratum_point"});
    expect_absent(triangles_only(matte(0.5f)), {"point_sample", "spot_", "attenuation"});
    expect_present(everything(), "kernels/integrators/whitted.cl", "directional_sample");
    expect_present(everything(), "kernels/integrators/whitted.cl", "spot_sample");
    for (const char *kind : {"emissive_mesh_sample", "emissive_sphere_sample", "emissive_frustum_sample", "emissive_disk_sample"})
        expect_present(everything(), "kernels/integrators/whitted.cl", kind);
}

TEST(Absence, WithoutTransparentMaterialsThereAreNoListsOfMedia) {
    for (const Material &material : {matte(0.5f), mirror(0.5f)}) expect_absent(spheres_only(material), {"core/interior.cl", "for_each_entry"});
    expect_present(spheres_only(glass(1.5f)), "kernels/integrators/whitted.cl", "core/interior.cl");
}

TEST(Absence, ShadowsAreNotFilteredUnlessAskedFor) {
    expect_absent(spheres_only(glass(1.5f)), {"core/shadow_filter.cl"});
    Scene opaque = spheres_only(matte(0.5f));
    opaque.integrator.filtered_shadows = true;
    expect_absent(opaque, {"core/shadow_filter.cl"});
    expect_present(everything(), "kernels/integrators/whitted.cl", "core/shadow_filter.cl");
}

/// A ball that moves while the shutter is open, or would if that were longer.
Scene moving_ball(const Shutter &shutter) {
    Scene scene = spheres_only(matte(0.5f));
    scene.shutter = shutter;
    const uint group = add_group(scene, "ball", std::exchange(scene.shapes, {}));
    EXPECT_FALSE(add_instance(scene, group, Motion({{0, AffineMap()}, {1, translation({1, 0, 0})}})));
    return scene;
}

TEST(Absence, WhereNothingMovesRaysHaveNoTime) {
    const std::vector<std::string> marks = {"core/time.cl", "cameras/shutter.cl", "primitives/motion", "motionpart", "polynomial("};
    expect_absent(everything(), marks);
    expect_absent(moving_ball({1, 1}), marks);
    expect_present(moving_ball({0, 1}), "kernels/stages/intersect.cl", "core/time.cl");
    expect_present(moving_ball({0, 1}), "kernels/stages/evaluate_surfaces.cl", "primitives/motion.cl");
    EXPECT_EQ(compile(moving_ball({0, 1})).place_words(), 2u);
    EXPECT_EQ(compile(moving_ball({1, 1})).place_words(), 1u);
}

TEST(Absence, WithoutInstancesThereIsOneLevel) {
    expect_absent(everything(), {"primitives/instance.cl", "two_levels", "group_closest_hit", "instanceblock", "packet_in_group"});
    Scene scene = everything();
    add_group(scene, "group", std::exchange(scene.shapes, {}));
    ASSERT_FALSE(add_instance(scene, 0, AffineMap()));
    expect_present(scene, "kernels/stages/intersect.cl", "group_closest_hit");
    expect_present(scene, "kernels/stages/evaluate_surfaces.cl", "primitives/instance.cl");
}

TEST(Absence, OtherAcceleratorsAreNotThere) {
    Scene scene = spheres_only(matte(0.5f));
    for (const AcceleratorKind &chosen : accelerator_kinds()) {
        scene.accelerator = chosen.name;
        for (const AcceleratorKind &other : accelerator_kinds()) {
            if (std::string(other.file) == chosen.file) continue;
            const std::string file = std::string("accelerators/") + other.file;
            expect_absent(scene, {file + ".cl", file + "_packets.cl", file + "_interleaved.cl"});
        }
        expect_absent(scene, {"_scalar.cl", "single_ray_x1.cl"});
        expect_present(scene, "kernels/stages/intersect.cl", std::string("accelerators/") + chosen.file + ".cl");
    }
}

TEST(Absence, WithOneLaneASingleRayHasNoTraversalOfEight) {
    for (const auto &[file, text] : expanded(spheres_only(glass(1.5f)), RayLanes::one)) {
        if (text.find("accelerators/levels.cl") == std::string::npos) continue;
        EXPECT_NE(text.find("accelerators/wide_bvh_scalar.cl"), std::string::npos) << file;
        for (const char *absent : {"accelerators/wide_bvh.cl", "single_ray_x8.cl", "primitive_hits_8.cl"})
            EXPECT_EQ(text.find(absent), std::string::npos) << file << " has " << absent;
    }
}

TEST(Absence, NobodyCountsWork) {
    Scene scene = spheres_only(matte(0.5f));
    for (const AcceleratorKind &chosen : accelerator_kinds()) {
        scene.accelerator = chosen.name;
        expect_absent(scene, {"accelerators/work.cl", "accelerators/work.h"});
    }
}

/// Kernels launched by a render.
std::set<std::string> launched_by(const Scene &scene) {
    std::map<std::string, std::uint64_t> before;
    for (const auto &[name, profile] : test_device().profile()) before[name] = profile.launches;
    render_scene(scene);
    test_device().finish();
    std::set<std::string> launched;
    for (const auto &[name, profile] : test_device().profile())
        if (profile.launches > before[name]) launched.insert(name);
    return launched;
}

TEST(Absence, WhatASceneDoesNotNeedIsNotLaunched) {
    Scene dark = spheres_only(matte(0.5f));
    dark.lights.clear();
    const auto opaque = launched_by(spheres_only(matte(0.5f))), unlit = launched_by(dark), shiny = launched_by(spheres_only(mirror(0.5f)));
    const char *any_hit = traversal_of_render(true, test_device().info(), compile(dark)).any_hit;
    EXPECT_TRUE(opaque.contains(any_hit));
    for (const char *kernel : {any_hit, "spawn_shadow_rays", "filter_shadow_rays"}) EXPECT_FALSE(unlit.contains(kernel)) << kernel;
    EXPECT_FALSE(opaque.contains("spawn_whitted"));
    EXPECT_FALSE(opaque.contains("filter_shadow_rays"));
    EXPECT_TRUE(shiny.contains("spawn_whitted"));
    dark.film.spp = 2, dark.film.filter = kind_number(filter_kinds(), "mitchell");
    const auto weighed = launched_by(dark);
    EXPECT_TRUE(weighed.contains("weigh_samples"));
    EXPECT_FALSE(opaque.contains("weigh_samples"));
    EXPECT_FALSE(weighed.contains("weigh_values"));
    dark.film.filter = kind_number(filter_kinds(), "tent"), dark.film.filter_radius = 1, dark.film.splat = true;
    const auto splatted = launched_by(dark);
    for (const char *kernel : {"weigh_splats", "cut_samples", "add_splats"})
        EXPECT_TRUE(splatted.contains(kernel) && !opaque.contains(kernel)) << kernel;
    EXPECT_FALSE(splatted.contains("add_samples"));
    for (const char *kernel : {"record_aov", "add_aov", "record_number"}) EXPECT_FALSE(opaque.contains(kernel)) << kernel;
}

/// Kernels made for a render, whether launched or not.
std::set<std::string> made_for(const Scene &scene) {
    Device device = Device::select();
    const CompiledScene compiled = compile(scene);
    const DeviceScene on_device(device, compiled);
    const Film film(device, scene.film);
    std::optional<Aovs> aovs;
    if (!scene.film.aovs.empty()) aovs.emplace(device, scene, compiled, on_device, scene.cameras[0], 64);
    const Renderer renderer(device, scene, compiled, on_device, scene.cameras[0], {});
    return device.kernels();
}

TEST(Absence, FilmsHaveTheKernelsOfTheirKindOnly) {
    const std::set<std::string> drawing = {"add_samples", "develop"}, splatting = {"weigh_splats", "cut_samples", "add_splats", "develop_splats"};
    const auto expect = [](const Scene &scene, const std::set<std::string> &there, const std::set<std::string> &absent) {
        const std::set<std::string> made = made_for(scene);
        for (const std::string &kernel : there) EXPECT_TRUE(made.contains(kernel)) << kernel;
        for (const std::string &kernel : absent) EXPECT_FALSE(made.contains(kernel)) << kernel;
    };
    Scene scene = spheres_only(matte(0.5f));
    scene.film.filter = kind_number(filter_kinds(), "gaussian"), scene.film.filter_radius = 1.5f;
    expect(scene, drawing, splatting);
    const auto wave_bytes = [](const Scene &of) {
        const CompiledScene compiled = compile(of);
        return Filter(test_device(), of.film, DeviceScene(test_device(), compiled).lists(), 1).bytes();
    };
    const std::size_t with_table = wave_bytes(scene);
    scene.film.splat = true;
    expect(scene, splatting, drawing);
    EXPECT_LT(wave_bytes(scene), with_table + FILTER_INTERVALS * sizeof(float)) << "values of the filter, but no table of places";
    const auto aov = [](const char *name) { return kind_number(aov_kinds(), name); };
    scene.film.aovs = {aov("normal"), aov("albedo")};
    expect(scene, {"add_aov_splats"}, {"add_aov"});
    scene.film.aovs = {aov("depth")};
    expect(scene, {"add_aov"}, {"add_aov_splats"});
    scene.film.aovs = {aov("depth"), aov("normal")};
    expect(scene, {"add_aov", "add_aov_splats"}, {});
    scene.film.aovs = {aov("primitive"), aov("samples")};
    expect(scene, {"record_number"}, {"add_aov", "add_aov_splats"});
}

TEST(Absence, OtherFiltersAreNotThere) {
    Scene scene = spheres_only(matte(0.5f));
    expect_absent(scene, {"filters/tent.cl", "filters/tabulated.cl"});
    scene.film.filter = kind_number(filter_kinds(), "tent");
    expect_absent(scene, {"filters/box.cl", "filters/tabulated.cl"});
    expect_present(scene, "kernels/stages/generate_camera_rays.cl", "filters/tent.cl");
    scene.film.splat = true;
    expect_absent(scene, {"filters/tent.cl"});
}

/// A triangle whose vertices have colours.
Scene coloured() {
    Scene scene = scene_with(matte(0.5f));
    MeshData mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, mesh.indices = {0, 1, 2}, mesh.colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    add_triangle_mesh(scene, 0, std::move(mesh));
    scene.ambient = Spectrum(1);
    return scene;
}

TEST(Absence, WithoutPicturesAndColoursOfVerticesNothingIsLookedUp) {
    Scene plain = coloured();
    plain.shapes.clear();
    add_triangle(plain, 0, {-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
    expect_absent(plain, {"core/tints.cl"});
    expect_present(coloured(), "kernels/integrators/whitted.cl", "core/tints.cl");
    EXPECT_FALSE(launched_by(plain).contains("look_up_textures"));
    EXPECT_TRUE(launched_by(coloured()).contains("look_up_textures"));
}

TEST(Absence, WhereNoMaterialChoosesAmongOthersNoneIsChosen) {
    Scene scene = spheres_only(matte(0.5f));
    expect_absent(scene, {"bsdfs/choosing.cl"});
    EXPECT_FALSE(launched_by(scene).contains("choose_materials"));
    const uint other = add_material(scene, mirror(0.5f));
    Scene mixed = spheres_only(make_choosing(choosing_kinds()[kind_number(choosing_kinds(), "mix")], {{other, other}, 0, Spectrum(0.5f)}));
    ASSERT_EQ(add_material(mixed, mirror(0.5f)), other);
    expect_present(mixed, "kernels/stages/evaluate_surfaces.cl", "bsdfs/choosing.cl");
    EXPECT_TRUE(launched_by(mixed).contains("choose_materials"));
}

/// Rough metal and smooth glass have none.
TEST(Absence, OnlyRoughGlassHasTablesOfLosses) {
    Scene scene = spheres_only(of_text(R"({"type": "dielectric"})"));
    scene.integrator.type = "path";
    add_sphere(scene, add_material(scene, of_text(R"({"type": "conductor", "metal": "gold", "roughness": 0.3})")), {2, 0, 0}, 1);
    const uint rough = add_material(scene, of_text(R"({"type": "dielectric", "roughness": 0.3})"));
    expect_absent(scene, {"bsdfs/losses.cl", "losstable", "loss_table"});
    EXPECT_LT(compile(scene).arena.size(), sizeof(LossTable));
    add_sphere(scene, rough, {4, 0, 0}, 1);
    expect_present(scene, "kernels/integrators/path.cl", "bsdfs/losses.cl");
    EXPECT_GT(compile(scene).arena.size(), sizeof(LossTable));
}

TEST(Absence, HitsOfOneKind) {
    Scene scene = spheres_only(matte(0.5f));
    scene.integrator.type = "path";
    EXPECT_FALSE(launched_by(scene).contains("group_hits"));
    add_sphere(scene, add_material(scene, make_null(Spectrum(0.5f))), {0, 0, 0}, 0.1f);
    EXPECT_EQ(launched_by(scene).contains("group_hits"), test_device().info().cpu);
}

/// A work-item of a GPU has no chunk of which others' code could be left out, and no room for a thousand hits.
TEST(Absence, HitsAreNotGroupedOnGpus) {
    Scene scene = spheres_only(matte(0.5f));
    scene.integrator.type = "path";
    for (const char *material : {R"({"type": "conductor", "metal": "gold"})", R"({"type": "dielectric"})", R"({"type": "plastic"})"})
        add_sphere(scene, add_material(scene, of_text(material)), {0.3f * float(scene.materials.size()), 0, 0}, 0.1f);
    Device as_gpu = Device::select("", 0, true);
    EXPECT_EQ(film_hash(render_scene(as_gpu, scene).film), film_hash(render_scene(scene).film));
    EXPECT_FALSE(as_gpu.kernels().contains("group_hits"));
}

TEST(Absence, PicturesThatNothingShowsAreNotOnTheDevice) {
    Scene scene = coloured();
    scene.textures.push_back({"", {}, {2, 1, {Spectrum(1), Spectrum(0)}, {}}});
    add_material(scene, matte(0.5f));
    scene.materials[1].record.diffuse_texture = 1;  // but nothing is made of it
    EXPECT_TRUE(compile(scene).texels.empty());
    scene.materials[0].record.diffuse_texture = 1;
    EXPECT_EQ(compile(scene).texels.size(), 2u);
}

TEST(Absence, WhatASceneDoesNotNeedIsNotAllocated) {
    const auto wave_bytes = [](const Scene &scene) {
        const CompiledScene compiled = compile(scene);
        const DeviceScene on_device(test_device(), compiled);
        return Renderer(test_device(), scene, compiled, on_device, scene.cameras[0], {}).wave_bytes();
    };
    Scene dark = spheres_only(matte(0.5f));
    dark.lights.clear();
    EXPECT_LT(wave_bytes(dark), wave_bytes(spheres_only(matte(0.5f))));
    EXPECT_LT(wave_bytes(spheres_only(matte(0.5f))), wave_bytes(spheres_only(mirror(0.5f))));
    EXPECT_LT(wave_bytes(spheres_only(mirror(0.5f))), wave_bytes(spheres_only(glass(1.5f))));
}

TEST(Absence, AProgramIsTheSameForScenesThatDifferInNumbersOnly) {
    Scene other = spheres_only(matte(0.7f));
    add_sphere(other, 0, {2, 0, 0}, 0.5f);
    other.lights.push_back(point_light({-3, 3, 3}, Spectrum(1)));
    other.integrator.max_depth = 17;
    EXPECT_EQ(expanded(spheres_only(matte(0.5f))), expanded(other));
}

}  // namespace
}  // namespace brandung
