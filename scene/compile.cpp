#include "scene/compile.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>

#include "kernels/core/items.h"
#include "scene/accelerators/accelerator.h"
#include "scene/error.h"
#include "scene/lights/enclosed_lights.h"
#include "scene/lights/light_rows.h"

namespace brandung {
namespace {

/// Kernels read record 0 of an array where they have none to read.
constexpr std::size_t largest_record = 256;

/// Grows in records, each array at a multiple of 64 bytes.
class Arena {
public:
    explicit Arena(std::vector<std::byte> &bytes) : bytes_(bytes) {}

    Span add(std::span<const std::byte> records, std::size_t count) {
        const std::size_t offset = (bytes_.size() + 63) / 64 * 64;
        bytes_.resize(offset + std::max(records.size(), largest_record));
        std::copy(records.begin(), records.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(offset));
        return {static_cast<uint>(offset / 64), static_cast<uint>(count)};
    }
    template <class T> Span add(const std::vector<T> &records) { return add(std::as_bytes(std::span(records)), records.size()); }

private:
    std::vector<std::byte> &bytes_;
};

/// A primitive of the scene: the i-th of a shape.
struct PrimitiveOf {
    const Shape *shape;
    std::size_t i;
};

std::vector<PrimitiveOf> primitives_in_order(const Scene &scene) {
    std::vector<PrimitiveOf> primitives;
    for (const auto &shape : scene.shapes)
        for (std::size_t i = 0; i < shape->count(); ++i) primitives.push_back({shape.get(), i});
    if (primitives.size() > MAX_PRIMITIVES) throw SceneError(fmt::format("{}: {} primitives are too many", scene.file, primitives.size()));
    return primitives;
}

std::vector<const PrimitiveKind *> kinds_in_use(const Scene &scene) {
    std::vector<const PrimitiveKind *> kinds;
    for (const PrimitiveKind *kind : primitive_kinds())
        if (std::any_of(scene.shapes.begin(), scene.shapes.end(), [&](const auto &shape) { return &shape->kind() == kind && shape->count() > 0; }))
            kinds.push_back(kind);
    return kinds;
}

uint number_of(const std::vector<const PrimitiveKind *> &kinds, const PrimitiveKind &kind) {
    return static_cast<uint>(std::find(kinds.begin(), kinds.end(), &kind) - kinds.begin());
}

/// Blocks of one kind; lanes without a primitive are all ones: no number, and NaN, which no ray meets.
std::vector<std::byte> write_blocks(const PrimitiveKind &kind, const std::vector<PrimitiveBlock> &blocks,
                                    const std::vector<PrimitiveOf> &primitives) {
    std::vector<std::byte> bytes(blocks.size() * kind.block_bytes, std::byte{0xff});
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        std::byte *block = bytes.data() + b * kind.block_bytes;
        for (uint lane = 0; lane < blocks[b].count; ++lane) {
            const uint number = blocks[b].references[lane];
            std::memcpy(block + lane * sizeof(uint), &number, sizeof number);
            primitives[number].shape->write_lane(primitives[number].i, lane, block);
        }
    }
    return bytes;
}

float extent_of(const std::vector<Reference> &references) {
    Bounds bounds;
    for (const Reference &reference : references) bounds.add(reference.bounds);
    if (bounds.empty()) return 0;
    const vec3 largest = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
    return std::max({largest.x, largest.y, largest.z});
}

bool is_textured(const Material &material) { return material.diffuse_texture != 0 || material.specular_texture != 0; }

void add_primitives(const Scene &scene, CompiledScene &compiled, Arena &arena) {
    const std::vector<PrimitiveOf> primitives = primitives_in_order(scene);
    compiled.primitives = kinds_in_use(scene);
    compiled.primitive_count = primitives.size();
    compiled.counts.resize(compiled.primitives.size());
    if (compiled.primitives.size() > MAX_PRIMITIVE_KINDS) throw SceneError(scene.file + ": too many kinds of primitives in one scene");

    std::vector<Reference> references;
    std::vector<ShadingRecord> shading;
    SharedTables tables;
    references.reserve(primitives.size()), shading.reserve(primitives.size());
    for (const PrimitiveOf &primitive : primitives) {
        const uint kind = number_of(compiled.primitives, primitive.shape->kind());
        ++compiled.counts[kind];
        references.push_back({primitive.shape->bounds(primitive.i), kind});
        tables.wants_uvs = is_textured(scene.materials.at(primitive.shape->material).record);
        ShadingRecord &record = shading.emplace_back(ShadingRecord{kind, primitive.shape->material, {}});
        primitive.shape->write_shading(primitive.i, record.words, tables);
    }

    const auto start = std::chrono::steady_clock::now();
    const AcceleratorKind &kind = find_accelerator(scene.accelerator);
    const BuiltAccelerator built = kind.build(references);
    compiled.accelerator = kind.name;
    compiled.accelerator_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    Group &world = compiled.header.world;
    world.extent = extent_of(references);
    for (std::size_t k = 0; k < compiled.primitives.size(); ++k)
        world.blocks[k] = arena.add(write_blocks(*compiled.primitives[k], built.blocks[k], primitives), built.blocks[k].size());
    world.nodes = arena.add(built.nodes, built.node_count);
    compiled.header.shading = arena.add(shading);
    compiled.header.vertex_normals = arena.add(tables.vertex_normals);
    compiled.header.vertex_uvs = arena.add(tables.vertex_uvs);
    compiled.header.vertex_colors = arena.add(tables.vertex_colors);
    compiled.tints |= !tables.vertex_colors.empty();
    if (tables.lack_uvs > 0)
        compiled.warnings["triangle with a texture, but without texture coordinates: has the colour at (0, 0)"] = static_cast<uint>(tables.lack_uvs);
    compiled.shading_normals = !tables.vertex_normals.empty();
}

template <class Records> std::vector<uint> kinds_of(const Records &records) {
    std::vector<uint> kinds;
    for (const auto &record : records) kinds.push_back(record.kind);
    std::sort(kinds.begin(), kinds.end());
    kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());
    return kinds;
}

/// By material: whether something of the scene has it.
std::vector<bool> materials_in_use(const Scene &scene) {
    std::vector<bool> used(scene.materials.size());
    for (const auto &shape : scene.shapes) used.at(shape->material) = true;
    return used;
}

bool has_eye_in(const Scene &scene, const std::string &material) {
    return std::any_of(scene.cameras.begin(), scene.cameras.end(), [&](const CameraDescription &camera) {
        return std::find(camera.inside.begin(), camera.inside.end(), material) != camera.inside.end();
    });
}

void count_media(const Scene &scene, const std::vector<bool> &used, CompiledScene &compiled) {
    if (!compiled.transmits) return;
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        const auto &[name, material] = scene.materials[m];
        compiled.media += (material.flags & MATERIAL_TRANSMITS) != 0 && (used[m] || has_eye_in(scene, name));
    }
    while (compiled.interior_size < std::min(compiled.media, max_interior_size)) compiled.interior_size = std::max(1u, 2 * compiled.interior_size);
}

void add_textures(const Scene &scene, const std::vector<Material> &used_materials, CompiledScene &compiled, Arena &arena) {
    std::vector<bool> used(scene.textures.size());
    const auto use = [&](uint number) {
        if (number > 0) used.at(number - 1) = true;
    };
    for (const Material &material : used_materials) use(material.diffuse_texture), use(material.specular_texture);
    use(scene.background_texture);
    TexturePixels pixels = pixels_of(scene.textures, used);
    compiled.header.textures = arena.add(pixels.records);
    compiled.header.background_texture = scene.background_texture;
    compiled.header.background_turn = scene.background_turn;
    compiled.texels = std::move(pixels.texels);
    compiled.tints |= !compiled.texels.empty();
}

void add_materials(const Scene &scene, CompiledScene &compiled, Arena &arena) {
    const std::vector<bool> used = materials_in_use(scene);
    std::vector<Material> materials, used_materials;
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        const Material &material = materials.emplace_back(scene.materials[m].record);
        if (!used[m]) continue;
        used_materials.push_back(material);
        compiled.reflects |= (material.flags & MATERIAL_REFLECTS) != 0;
        compiled.transmits |= (material.flags & MATERIAL_TRANSMITS) != 0;
        compiled.highlights |= (material.flags & MATERIAL_HIGHLIGHT) != 0;
    }
    count_media(scene, used, compiled);
    add_textures(scene, used_materials, compiled, arena);
    compiled.bsdfs = kinds_of(used_materials);
    compiled.header.materials = arena.add(materials);
}

void add_lights(const Scene &scene, CompiledScene &compiled, Arena &arena) {
    compiled.filters_shadows = scene.integrator.filtered_shadows && compiled.transmits;
    if (const uint enclosed = compiled.filters_shadows ? 0 : count_enclosed_lights(scene))
        compiled.warnings
            ["light inside a transparent object: shadows are opaque, so that it lights nothing outside; --shadows filtered lets it through"] +=
            enclosed;
    const LightRows lights = make_light_rows(scene);
    compiled.lights = kinds_of(lights.rows);
    compiled.light_counts = lights.counts;
    compiled.dark_emitters = lights.dark;
    compiled.header.emissive_faces = arena.add(lights.faces);
    compiled.header.lights = arena.add(lights.rows);
}

}  // namespace

CompiledScene compile(const Scene &scene) {
    CompiledScene compiled;
    compiled.warnings = scene.warnings;
    Arena arena(compiled.arena);
    add_primitives(scene, compiled, arena);
    add_materials(scene, compiled, arena);
    add_lights(scene, compiled, arena);
    compiled.filter = scene.film.filter;
    compiled.header.background = scene.background;
    compiled.header.ambient = scene.ambient;
    return compiled;
}

}  // namespace brandung
