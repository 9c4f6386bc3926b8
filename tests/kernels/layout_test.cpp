/// Records that both languages declare have the same size and members at the same places in both.
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "kernels/accelerators/bounding_volumes.h"
#include "kernels/accelerators/kd_tree.h"
#include "kernels/accelerators/octree.h"
#include "kernels/accelerators/uniform_grid.h"
#include "kernels/accelerators/wide_bvh.h"
#include "kernels/accelerators/work.h"
#include "kernels/bsdfs/bsdf.h"
#include "kernels/bsdfs/choice.h"
#include "kernels/bsdfs/conductor.h"
#include "kernels/bsdfs/dielectric.h"
#include "kernels/bsdfs/diffuse.h"
#include "kernels/bsdfs/loss_table.h"
#include "kernels/bsdfs/null.h"
#include "kernels/bsdfs/phong.h"
#include "kernels/bsdfs/plastic.h"
#include "kernels/bsdfs/thin_dielectric.h"
#include "kernels/bsdfs/whitted.h"
#include "kernels/cameras/fisheye.h"
#include "kernels/cameras/orthographic.h"
#include "kernels/cameras/panorama.h"
#include "kernels/cameras/perspective.h"
#include "kernels/cameras/thin_lens.h"
#include "kernels/core/items.h"
#include "kernels/core/params.h"
#include "kernels/core/scene.h"
#include "kernels/filters/filter.h"
#include "kernels/filters/splat.h"
#include "kernels/lights/directional.h"
#include "kernels/lights/emission.h"
#include "kernels/lights/environment.h"
#include "kernels/lights/light.h"
#include "kernels/lights/light_choice.h"
#include "kernels/lights/point.h"
#include "kernels/lights/spot.h"
#include "kernels/primitives/disk.h"
#include "kernels/primitives/frustum.h"
#include "kernels/primitives/instance.h"
#include "kernels/primitives/motion.h"
#include "kernels/primitives/smooth_triangle.h"
#include "kernels/primitives/sphere.h"
#include "kernels/primitives/surface.h"
#include "kernels/selftest/all_hits.h"
#include "kernels/stages/describe_hits.h"
#include "kernels/stages/describe_lights.h"
#include "kernels/stages/describe_paths.h"
#include "kernels/stages/face_list.h"
#include "kernels/textures/texture.h"
#include "tests/support/probe.h"

namespace brandung {
namespace {

/// Size and members' offsets, in bytes.
struct Layout {
    std::size_t size;
    std::map<std::string, std::size_t> members;
    bool operator==(const Layout &) const = default;
};
using Layouts = std::map<std::string, Layout>;

void PrintTo(const Layout &layout, std::ostream *out) {
    *out << layout.size << " bytes:";
    for (const auto &[name, offset] : layout.members) *out << " " << name << " at " << offset;
}

// One entry per member; the preprocessor needs as many rounds as a record has members.
#define AGAIN()
#define ROUNDS(...) ROUNDS_3(ROUNDS_3(ROUNDS_3(ROUNDS_3(ROUNDS_3(ROUNDS_3(__VA_ARGS__))))))
#define ROUNDS_3(...) ROUNDS_1(ROUNDS_1(ROUNDS_1(__VA_ARGS__)))
#define ROUNDS_1(...) __VA_ARGS__
#define MEMBERS(Record, name, ...) {#name, offsetof(Record, name)}, __VA_OPT__(MORE_MEMBERS AGAIN()()(Record, __VA_ARGS__))
#define MORE_MEMBERS() MEMBERS
#define RECORD(Record, ...)                                          \
    {                                                                \
#Record, {                                                   \
            sizeof(Record), { ROUNDS(MEMBERS(Record, __VA_ARGS__)) } \
        }                                                            \
    }

/// As the host's compiler has them.
const Layouts &host_layouts() {
    static const Layouts layouts = {
        RECORD(vec2, x, y),
        RECORD(vec3, x, y, z),
        RECORD(Ray, origin, t_max, direction, tag),
        RECORD(Hit, t, u, v, primitive),
        RECORD(Path, throughput, slot, branch, depth),
        RECORD(SurfacePoint, origin, material, normal, flags),
        RECORD(SurfaceInterface, geometric, eta, beyond),
        RECORD(Tints, diffuse, specular),
        RECORD(TextureRecord, offset, width, height, flags),
        RECORD(HitDescription, p, error, geometric, normal, cosine, cosine_squared_beyond, emission, ambient),
        RECORD(LightDescription, irradiance, cosine, refusals),
        RECORD(MetDescription, radiance, weight),
        RECORD(NextDescription, ray, weight, scattered, pdf, survival, roulette, refusals),
        RECORD(AskedDescription, row, chance, irradiance, inverse_density, cosine, value, pdf, weight, radiance, refusals),
        RECORD(PassedFace, p, enters, hit, transmission, instance),
        RECORD(Tally, rays, hits),
        RECORD(MetPrimitives, closest, all),
        RECORD(Sample, sum),
        RECORD(Integer128, low, high),
        RECORD(FilmPixel, sums, squares, counts),
        RECORD(PixelWeights, sums, squares),
        RECORD(AovPixel, sums, weights),
        RECORD(Camera, position, width, height, words),
        RECORD(ShutterParams, open, close, parts),
        RECORD(BatchParams, pixels, first_sample, samples, spp, seed, position),
        RECORD(FilterParams, radius, negative_tail, weight),
        RECORD(Splat, x, y, along_x, along_y),
        RECORD(FilmBand, first_row, rows, first_column, width),
        RECORD(PathParams, max_depth, roulette_depth, bundles),
        RECORD(Bundles, light, diffuse, glossy, transmission),
        RECORD(WhittedParams, max_depth, threshold),
        RECORD(Span, offset, count),
        RECORD(ShadingRecord, kind, material, words),
        RECORD(Material, kind, flags, priority, eta, emission, diffuse_texture, specular_texture, words),
        RECORD(Light, kind, words),
        RECORD(Group, blocks, nodes, extent),
        RECORD(SceneHeader, world, groups, instances, motion_parts, shading, vertex_normals, vertex_uvs, vertex_colors, emissive_faces, materials,
               lights, light_choices, emission_chance, textures, environment_rows, environment_begins, environment_marks, environment_row_count,
               environment_columns, environment_density, background, ambient, background_texture, background_turn),
        RECORD(Transform, x, y, z, origin),
        RECORD(Instance, to_world, to_group, group, material, first_part, parts, spare),
        RECORD(MotionPart, begin, rate, to_world, to_group, mismatch, spare),
        RECORD(InstanceBlock, primitive, low, high),
        RECORD(CellSpans, cells, items, lanes),
        RECORD(UniformGrid, spans, low, size, columns),
        RECORD(OctreeNode, child),
        RECORD(Octree, spans, low, unit),
        RECORD(KdNode, plane, word),
        RECORD(KdTree, spans, low, high),
        RECORD(VolumeNode, low, high, children, volume),
        RECORD(Volume, words),
        RECORD(VolumeTree, node_count, spare),
        RECORD(Work, steps, cells, empty_cells, listed, blocks, tests, missed, idle, served),
        RECORD(BvhNode, low, high, child, spare),
        RECORD(Whitted, ambient, diffuse, specular, reflection, transmission, exponent, fresnel),
        RECORD(Diffuse, reflectance),
        RECORD(AngleCurve, terms),
        RECORD(Conductor, eta, k, specular, multiple, alpha, distribution, lost),
        RECORD(Plastic, diffuse, eta, internal, scale, alpha, distribution, nonlinear, coat),
        RECORD(ModifiedPhong, diffuse, specular, exponent),
        RECORD(Dielectric, reflection, transmission, alpha, distribution, losses),
        RECORD(LossRow, mean, at),
        RECORD(LossTable, rows),
        RECORD(ThinDielectric, reflection, transmission),
        RECORD(Null, transmission),
        RECORD(Choice, members, by_side, amount),
        RECORD(BsdfPoint, wo, eta, diffuse_tint, specular_tint),
        RECORD(BsdfValue, value, pdf),
        RECORD(BsdfSample, wi, weight, pdf),
        RECORD(Phong, diffuse, specular, exponent),
        RECORD(Split, reflected, refracted),
        RECORD(BsdfPoint, wo, eta, diffuse_tint, specular_tint),
        RECORD(BsdfValue, value, pdf),
        RECORD(BsdfSample, wi, weight, pdf),
        RECORD(PointLight, position, intensity, attenuation),
        RECORD(DirectionalLight, direction, irradiance),
        RECORD(SpotLight, position, direction, intensity, attenuation, edge, steepness),
        RECORD(Stratum, salt, cell),
        RECORD(Emission, power, stratum, instance, dark),
        RECORD(Environment, radiance),
        RECORD(EnvironmentRow, begin, high, density),
        RECORD(Texel, red_green, blue),
        RECORD(EmissivePoint, p, normal, error, inverse_density),
        RECORD(EmissiveMesh, emission, first_face, faces),
        RECORD(EmissiveSphere, emission, center, radius),
        RECORD(EmissiveDisk, emission, center, normal, radius),
        RECORD(EmissiveFrustum, emission, center, along, radius, rise),
        RECORD(EmissiveFlat, power, folded, corner, u, v, instance, dark),
        RECORD(EmissiveFace, corner, u, v, normal, folded, error, kept, alias, first, last),
        RECORD(LightChoice, kept, alias, inverse_chance, radiance),
        RECORD(LightSample, direction, ray_direction, distance, irradiance, inverse_density),
        RECORD(Surface, p, error, geometric, normal, lift),
        RECORD(Pattern, uv, color),
        RECORD(SphereBlock, primitive, x, y, z, radius),
        RECORD(SphereShading, center, radius),
        RECORD(TriangleBlock, primitive, a, b, c),
        RECORD(TriangleShading, a, b, c, uvs, colors),
        RECORD(SmoothTriangleShading, flat, normals),
        RECORD(VertexNormals, a, b, c),
        RECORD(VertexUvs, a, b, c),
        RECORD(VertexColors, a, b, c),
        RECORD(DiskBlock, primitive, center, normal, radius, low, high),
        RECORD(DiskShading, center, normal, radius),
        RECORD(FrustumBlock, primitive, center, axis, half_length, radius, slope, side, low, high),
        RECORD(FrustumShading, center, axis, radius, slope, half_length),
        RECORD(Perspective, corner, right, down),
        RECORD(Orthographic, corner, right, down, direction),
        RECORD(ThinLens, corner, right, down, across, along, blades, turned),
        RECORD(Panorama, forward, right, up, width, height),
        RECORD(Fisheye, forward, right, up, aspect, angle, sine, equisolid),
    };
    return layouts;
}
#undef RECORD
#undef MORE_MEMBERS
#undef MEMBERS
#undef ROUNDS_1
#undef ROUNDS_3
#undef ROUNDS
#undef AGAIN

/// Names of the records that headers under kernels/ declare, and of their members, in order.
struct Declared {
    std::vector<std::string> headers;
    std::map<std::string, std::vector<std::string>> records;
};

std::vector<std::string> members_of(const std::string &body) {
    std::vector<std::string> names;
    static const std::regex declaration(R"(\w+\s+([^;]+);)"), name(R"((\w+)\s*(\[[^,]*)?(,|$))");
    for (auto line = std::sregex_iterator(body.begin(), body.end(), declaration); line != std::sregex_iterator(); ++line) {
        const std::string list = (*line)[1];
        for (auto one = std::sregex_iterator(list.begin(), list.end(), name); one != std::sregex_iterator(); ++one) names.push_back((*one)[1]);
    }
    return names;
}

Declared declared_records() {
    namespace fs = std::filesystem;
    Declared declared;
    static const std::regex record(R"(typedef struct \{([^}]*)\} (\w+);)"), comment(R"(//[^\n]*)");
    for (const auto &file : fs::recursive_directory_iterator(BRANDUNG_SOURCE_DIR "/kernels")) {
        if (file.path().extension() != ".h") continue;
        declared.headers.push_back(fs::relative(file.path(), BRANDUNG_SOURCE_DIR).string());
        std::ifstream in(file.path());
        const std::string text = std::regex_replace(std::string(std::istreambuf_iterator<char>(in), {}), comment, "");
        for (auto match = std::sregex_iterator(text.begin(), text.end(), record); match != std::sregex_iterator(); ++match)
            declared.records[(*match)[2]] = members_of((*match)[1]);
    }
    return declared;
}

/// As the kernels' compiler has them: the probe's items are the records' sizes and their members' offsets, one after another.
Layouts device_layouts(const Declared &declared) {
    std::string text, values;
    std::size_t count = 0;
    for (const std::string &header : declared.headers) text += "#include \"" + header + "\"\n";
    const auto add = [&](const std::string &value) { values += "    if (i == " + std::to_string(count++) + "u) result[i] = (uint)" + value + ";\n"; };
    for (const auto &[record, members] : declared.records) {
        add("sizeof(" + record + ")");
        for (const std::string &member : members) add("__builtin_offsetof(" + record + ", " + member + ")");
    }
    const std::vector<uint> results =
        Probe(text + "kernel void probe(const global uint *numbers, global uint *result) {\n    const uint i = numbers[get_global_id(0)];\n" +
              values + "}\n")
            .run<uint>([count] {
                std::vector<uint> numbers(count);
                for (uint i = 0; i < count; ++i) numbers[i] = i;
                return numbers;
            }());
    Layouts layouts;
    std::size_t i = 0;
    for (const auto &[record, members] : declared.records) {
        Layout &layout = layouts[record];
        layout.size = results[i++];
        for (const std::string &member : members) layout.members[member] = results[i++];
    }
    return layouts;
}

TEST(Layout, RecordsAreTheSameInBothLanguages) {
    const Layouts device = device_layouts(declared_records());
    EXPECT_GT(device.size(), 25u);
    for (const auto &[record, layout] : device) {
        const auto host = host_layouts().find(record);
        if (host == host_layouts().end()) {
            ADD_FAILURE() << "record " << record << " is not in this test's list";
        } else {
            EXPECT_EQ(layout, host->second) << record;
        }
    }
    EXPECT_EQ(device.size(), host_layouts().size()) << "a record in this test's list is declared nowhere";
}

TEST(Layout, WhatTravelsHasItsPromisedSize) {
    EXPECT_EQ(sizeof(Ray), 32u);
    EXPECT_EQ(sizeof(Hit), 16u);
    EXPECT_EQ(sizeof(Path), 24u);
    EXPECT_EQ(sizeof(SurfacePoint), 32u);
    EXPECT_EQ(sizeof(ShadingRecord), 64u);
    EXPECT_EQ(sizeof(Material), 128u);
    EXPECT_EQ(sizeof(Instance), 128u);
    EXPECT_EQ(sizeof(Light), 64u);
    EXPECT_EQ(sizeof(BvhNode), 256u);
    EXPECT_EQ(sizeof(vec3), 12u);
    EXPECT_EQ(sizeof(Sample), 48u);
}

TEST(Layout, MembersAreFoundInDeclarations) {
    EXPECT_EQ(members_of(" vec3 center, axis;  uint words[14]; float low[3][BLOCK_SIZE], high[3][BLOCK_SIZE]; uint count; "),
              (std::vector<std::string>{"center", "axis", "words", "low", "high", "count"}));
}

}  // namespace
}  // namespace brandung
