#include "scene/compile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>
#include <utility>

#include "kernels/accelerators/wide_bvh.h"
#include "kernels/bsdfs/dielectric.h"
#include "scene/bsdfs/bsdf.h"
#include "scene/bsdfs/losses.h"
#include "scene/bsdfs/make.h"
#include "scene/lights/light.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

/// So many spheres of glass, each with a material of its own.
Scene glass_spheres(uint count) {
    Scene scene;
    scene.cameras.push_back({.name = "camera"});
    for (uint i = 0; i < count; ++i) add_sphere(scene, add_material(scene, glass(1.5f)), vec3(0), float(i + 1));
    return scene;
}

TEST(Compile, ListsOfMediaHoldEveryTransparentMaterialUpToEight) {
    EXPECT_EQ(compile(glass_spheres(0)).interior_size, 0u);
    EXPECT_EQ(compile(glass_spheres(1)).interior_size, 1u);
    EXPECT_EQ(compile(glass_spheres(3)).interior_size, 4u);
    const CompiledScene eight = compile(glass_spheres(8));
    EXPECT_EQ(eight.interior_size, 8u);
    EXPECT_TRUE(eight.warnings.empty());
}

TEST(Compile, ListsOfMediaHoldEightOfMore) {
    const CompiledScene compiled = compile(glass_spheres(11));
    EXPECT_EQ(compiled.interior_size, 8u);
    EXPECT_EQ(compiled.media, 11u);
}

/// What nothing is made of but the eye is in surrounds what the eye sees.
TEST(Compile, ListsOfMediaHoldWhatTheEyeIsIn) {
    Scene scene = glass_spheres(1);
    const uint water = add_material(scene, glass(1.33f));
    EXPECT_EQ(compile(scene).interior_size, 1u);
    scene.cameras.push_back({.name = "diver", .inside = {scene.materials[water].name}});
    EXPECT_EQ(compile(scene).interior_size, 2u);
}

TEST(Compile, KeepsTheScenesWarnings) {
    Scene scene = glass_spheres(1);
    add_sphere(scene, 0, vec3(0), 0);
    EXPECT_EQ(compile(scene).warnings, scene.warnings);
}

/// So that one set of kernels suits every scene.
TEST(Compile, ForAllKindsNothingDependsOnWhatTheSceneHas) {
    const CompiledScene compiled = compile(Scene(), {.kinds = Kinds::all});
    EXPECT_EQ(compiled.primitives, primitive_kinds());
    EXPECT_EQ(compiled.bsdfs.size(), bsdf_kinds().size());
    EXPECT_EQ(compiled.lights.size(), light_kinds().size());
    EXPECT_TRUE(compiled.reflects && compiled.transmits && compiled.instances && compiled.emissive_instances && compiled.highlights &&
                compiled.shading_normals && compiled.tints);
    EXPECT_EQ(compiled.interior_size, max_interior_size);
    EXPECT_EQ(compiled.instance_count, 0u);
    EXPECT_TRUE(compiled.losses);
    EXPECT_GE(compiled.arena.size(), std::size_t{64} * compiled.header.materials.offset + sizeof(LossTable)) << "kernels read what is not there";
}

/// Of those in use.
TEST(Compile, RoughDielectricsFindTheirTableBehindTheMaterials) {
    Scene scene = glass_spheres(1);
    EXPECT_FALSE(compile(scene).losses);
    Dielectric view{};
    view.reflection = view.transmission = Spectrum(1), view.alpha = 0.3f, view.distribution = 1;
    const uint rough = add_material(scene, material_of_kind("dielectric", MATERIAL_TRANSMITS | MATERIAL_LOSES, view));
    EXPECT_FALSE(compile(scene).losses) << "nothing is made of it";
    add_sphere(scene, rough, vec3(0), 9);
    scene.integrator.type = "path";
    const CompiledScene compiled = compile(scene);
    EXPECT_TRUE(compiled.losses);
    const std::byte *material = compiled.arena.data() + std::size_t{64} * compiled.header.materials.offset + rough * sizeof(Material);
    Material record;
    std::memcpy(&record, material, sizeof record);
    const std::byte *table = material + offsetof(Material, words) + view_of<Dielectric>(record.words).losses * sizeof(uint);
    ASSERT_LE(table + sizeof(LossTable), compiled.arena.data() + compiled.arena.size());
    const LossTable expected = loss_table_of({0.3f, 1});
    EXPECT_EQ(std::memcmp(table, &expected, sizeof expected), 0);
}

/// Who only asks what a scene has need not wait for tables: they are there, and 0.
TEST(Compile, LossesAreComputedForRendersOnly) {
    Scene scene;
    Dielectric view{};
    for (const float alpha : {0.1f, 0.2f, 0.3f}) {
        view.alpha = alpha;
        add_sphere(scene, add_material(scene, material_of_kind("dielectric", MATERIAL_TRANSMITS | MATERIAL_LOSES, view)), vec3(0), 1);
    }
    scene.integrator.type = "path";
    const CompiledScene without = compile(scene, {.computes_losses = false}), with = compile(scene);
    const auto tables = [](const CompiledScene &compiled) {
        const std::size_t begin = std::size_t{64} * compiled.header.materials.offset + compiled.header.materials.count * sizeof(Material);
        return std::span(compiled.arena).subspan(begin, 3 * sizeof(LossTable));
    };
    EXPECT_EQ(without.arena.size(), with.arena.size());
    const auto is_zero = [](std::byte byte) { return byte == std::byte{0}; };
    EXPECT_TRUE(std::all_of(tables(without).begin(), tables(without).end(), is_zero));
    EXPECT_FALSE(std::all_of(tables(with).begin(), tables(with).end(), is_zero));
}

/// Of two shapes in a group one shines by itself, and both where an instance's material replaces theirs by one that does.
TEST(Compile, EmissiveShapesOfInstancesAreLights) {
    Scene scene;
    scene.file = "scene";
    const uint dull = add_material(scene, matte(0.5f));
    const uint lamp = add_material(scene, emitter(Spectrum(1)));
    add_sphere(scene, dull, {0, 0, 0}, 1), add_sphere(scene, lamp, {3, 0, 0}, 1);
    add_group(scene, "pair", std::exchange(scene.shapes, {}));
    ASSERT_FALSE(add_instance(scene, 0, AffineMap()));
    EXPECT_EQ(compile(scene).header.lights.count, 1u);
    ASSERT_FALSE(add_instance(scene, 0, AffineMap(), lamp));
    EXPECT_EQ(compile(scene).header.lights.count, 3u);
    ASSERT_FALSE(add_instance(scene, 0, AffineMap(), dull));
    const CompiledScene compiled = compile(scene);
    EXPECT_EQ(compiled.header.lights.count, 3u);
    EXPECT_EQ(compiled.light_counts.at("emissive_sphere"), 3u);
    EXPECT_TRUE(compiled.emissive_instances);
}

/// Bytes of a span of records in the arena.
template <class Record> std::span<const std::byte> records_of(const CompiledScene &compiled, Span span) {
    return std::span(compiled.arena).subspan(std::size_t{64} * span.offset, span.count * sizeof(Record));
}

TEST(Compile, GroupsAndTheWorldAreBuiltInTheScenesQuality) {
    Scene scene = empty_scene();
    add_soup(scene, 0, {.of_each = 500, .size = 1});
    add_group(scene, "soup", std::exchange(scene.shapes, {}));
    ASSERT_FALSE(add_instance(scene, 0, AffineMap()));
    add_soup(scene, 0, {.of_each = 500, .size = 1, .seed = 2});
    const auto nodes_of = [](const CompiledScene &compiled, const Group &group) {
        const auto bytes = records_of<BvhNode>(compiled, group.nodes);
        return std::vector(bytes.begin(), bytes.end());
    };
    const auto group_of = [](const CompiledScene &compiled) {
        Group group;
        std::memcpy(&group, records_of<Group>(compiled, compiled.header.groups).data(), sizeof group);
        return group;
    };
    const CompiledScene fast = compile(scene);
    scene.accelerator_quality = BuildQuality::high;
    const CompiledScene high = compile(scene);
    EXPECT_NE(nodes_of(fast, fast.header.world), nodes_of(high, high.header.world));
    EXPECT_NE(nodes_of(fast, group_of(fast)), nodes_of(high, group_of(high)));
}

}  // namespace
}  // namespace brandung
