#include "scene/compile.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <set>

#include "kernels/core/items.h"
#include "kernels/primitives/instance.h"
#include "scene/accelerators/accelerator.h"
#include "scene/error.h"

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

using Shapes = std::vector<std::unique_ptr<Shape>>;

/// A primitive of the scene: the i-th of a shape.
struct PrimitiveOf {
    const Shape *shape;
    std::size_t i;
};

/// What shares a space: primitives in scene order, numbered from `first` on.
struct Space {
    std::vector<PrimitiveOf> primitives;
    uint first;
    bool is_textured = false;  ///< whether an instance replaces its materials by one with a texture
};

Space space_of(const Shapes &shapes, std::size_t first) {
    Space space{{}, static_cast<uint>(first)};
    for (const auto &shape : shapes)
        for (std::size_t i = 0; i < shape->count(); ++i) space.primitives.push_back({shape.get(), i});
    return space;
}

/// The world, then the groups in use.
std::vector<const Shapes *> shapes_in_use(const Scene &scene) {
    std::vector<const Shapes *> result = {&scene.shapes};
    for (const std::size_t group : groups_in_use(scene)) result.push_back(&scene.groups[group].shapes);
    return result;
}

/// Of one of groups_in_use.
std::size_t place_in(const std::vector<std::size_t> &used, std::size_t group) {
    return static_cast<std::size_t>(std::lower_bound(used.begin(), used.end(), group) - used.begin());
}

bool is_textured(const Material &material) { return material.diffuse_texture != 0 || material.specular_texture != 0; }

std::vector<Space> spaces_in_use(const Scene &scene) {
    std::vector<Space> spaces;
    std::size_t count = 0;
    for (const Shapes *shapes : shapes_in_use(scene)) {
        spaces.push_back(space_of(*shapes, count));
        count += spaces.back().primitives.size();
        if (count > MAX_PRIMITIVES) throw SceneError(fmt::format("{}: {} primitives are too many", scene.file, count));
    }
    const std::vector<std::size_t> used = groups_in_use(scene);
    for (const PlacedGroup &instance : scene.instances) {
        if (instance.material == NO_MATERIAL || !is_textured(scene.materials.at(instance.material).record)) continue;
        spaces[1 + place_in(used, instance.group)].is_textured = true;
    }
    return spaces;
}

std::vector<const PrimitiveKind *> kinds_in_use(const Scene &scene) {
    std::set<const PrimitiveKind *> used;
    for (const Shapes *shapes : shapes_in_use(scene))
        for (const auto &shape : *shapes)
            if (shape->count() > 0) used.insert(&shape->kind());
    std::vector<const PrimitiveKind *> kinds;
    for (const PrimitiveKind *kind : primitive_kinds())
        if (used.contains(kind)) kinds.push_back(kind);
    return kinds;
}

uint number_of(const std::vector<const PrimitiveKind *> &kinds, const PrimitiveKind &kind) {
    return static_cast<uint>(std::find(kinds.begin(), kinds.end(), &kind) - kinds.begin());
}

/// Blocks of one kind; `write_lane` is given the reference of each lane. Lanes without a primitive are all ones: no number, and NaN, which no ray
/// meets.
template <class WriteLane>
std::vector<std::byte> write_blocks(const std::vector<PrimitiveBlock> &blocks, std::size_t block_bytes, const WriteLane &write_lane) {
    std::vector<std::byte> bytes(blocks.size() * block_bytes, std::byte{0xff});
    for (std::size_t b = 0; b < blocks.size(); ++b)
        for (uint lane = 0; lane < blocks[b].count; ++lane) write_lane(blocks[b].references[lane], lane, bytes.data() + b * block_bytes);
    return bytes;
}

std::vector<std::byte> write_primitives(const PrimitiveKind &kind, const std::vector<PrimitiveBlock> &blocks, const Space &space) {
    return write_blocks(blocks, kind.block_bytes, [&](uint reference, uint lane, std::byte *block) {
        const uint number = space.first + reference;
        std::memcpy(block + lane * sizeof(uint), &number, sizeof number);
        space.primitives[reference].shape->write_lane(space.primitives[reference].i, lane, block);
    });
}

/// Instances are numbered from 1 on; their references follow those of the world's primitives.
std::vector<std::byte> write_instances(const std::vector<PrimitiveBlock> &blocks, const Scene &scene, std::size_t first_reference) {
    return write_blocks(blocks, sizeof(InstanceBlock), [&](uint reference, uint lane, std::byte *bytes) {
        InstanceBlock &block = *reinterpret_cast<InstanceBlock *>(bytes);
        const std::size_t i = reference - first_reference;
        block.primitive[lane] = static_cast<uint>(i + 1);
        for (int axis = 0; axis < 3; ++axis) {
            block.low[axis][lane] = scene.instances[i].bounds.low[axis];
            block.high[axis][lane] = scene.instances[i].bounds.high[axis];
        }
    });
}

float extent_of(const std::vector<Reference> &references) {
    Bounds bounds;
    for (const Reference &reference : references) bounds.add(reference.bounds);
    if (bounds.empty()) return 0;
    const vec3 largest = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
    return std::max({largest.x, largest.y, largest.z});
}

void add_shading(const Scene &scene, const std::vector<Space> &spaces, CompiledScene &compiled, Arena &arena) {
    std::vector<ShadingRecord> shading;
    SharedTables tables;
    compiled.counts.resize(compiled.primitives.size());
    for (const Space &space : spaces) {
        for (const PrimitiveOf &primitive : space.primitives) {
            const uint kind = number_of(compiled.primitives, primitive.shape->kind());
            ++compiled.counts[kind];
            tables.wants_uvs = space.is_textured || is_textured(scene.materials.at(primitive.shape->material).record);
            ShadingRecord &record = shading.emplace_back(ShadingRecord{kind, primitive.shape->material, {}});
            primitive.shape->write_shading(primitive.i, record.words, tables);
        }
    }
    compiled.primitive_count = shading.size();
    compiled.header.shading = arena.add(shading);
    compiled.header.vertex_normals = arena.add(tables.vertex_normals);
    compiled.header.vertex_uvs = arena.add(tables.vertex_uvs);
    compiled.header.vertex_colors = arena.add(tables.vertex_colors);
    compiled.tints |= !tables.vertex_colors.empty();
    if (tables.lack_uvs > 0)
        compiled.warnings["triangle with a texture, but without texture coordinates: has the colour at (0, 0)"] = static_cast<uint>(tables.lack_uvs);
    compiled.shading_normals = !tables.vertex_normals.empty();
}

/// The accelerator of a space, over its primitives and, in the world, the instances.
Group add_space(const Scene &scene, const Space &space, bool is_world, CompiledScene &compiled, Arena &arena) {
    const uint kinds = static_cast<uint>(compiled.primitives.size());
    std::vector<Reference> references;
    references.reserve(space.primitives.size());
    for (const PrimitiveOf &primitive : space.primitives)
        references.push_back({primitive.shape->bounds(primitive.i), number_of(compiled.primitives, primitive.shape->kind())});
    if (is_world)
        for (const PlacedGroup &instance : scene.instances) references.push_back({instance.bounds, kinds});

    const auto start = std::chrono::steady_clock::now();
    const AcceleratorKind &kind = find_accelerator(scene.accelerator);
    const BuiltAccelerator built = kind.build(references);
    compiled.accelerator = kind.name;
    compiled.accelerator_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    Group group{};
    group.extent = extent_of(references);
    for (std::size_t k = 0; k < kinds; ++k)
        group.blocks[k] = arena.add(write_primitives(*compiled.primitives[k], built.blocks[k], space), built.blocks[k].size());
    if (is_world && !scene.instances.empty())
        group.blocks[kinds] = arena.add(write_instances(built.blocks[kinds], scene, space.primitives.size()), built.blocks[kinds].size());
    group.nodes = arena.add(built.nodes, built.node_count);
    return group;
}

/// Their groups are numbered among those in use.
void add_instances(const Scene &scene, const std::vector<Group> &groups, CompiledScene &compiled, Arena &arena) {
    const std::vector<std::size_t> used = groups_in_use(scene);
    const Transform identity = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
    std::vector<Instance> instances = {Instance{identity, identity, 0, NO_MATERIAL, {}}};
    for (const PlacedGroup &placed : scene.instances) {
        const uint group = static_cast<uint>(place_in(used, placed.group));
        instances.push_back({placed.transforms.to_world, placed.transforms.to_group, group, placed.material, {}});
    }
    compiled.header.groups = arena.add(groups);
    compiled.header.instances = arena.add(instances);
    compiled.group_count = groups.size();
    compiled.instance_count = scene.instances.size();
}

void add_primitives(const Scene &scene, CompiledScene &compiled, Arena &arena) {
    const std::vector<Space> spaces = spaces_in_use(scene);
    compiled.primitives = kinds_in_use(scene);
    if (compiled.primitives.size() + (scene.instances.empty() ? 0 : 1) > MAX_PRIMITIVE_KINDS)
        throw SceneError(scene.file + ": too many kinds of primitives in one scene");
    compiled.header.world = add_space(scene, spaces.front(), true, compiled, arena);
    std::vector<Group> groups;
    for (std::size_t g = 1; g < spaces.size(); ++g) groups.push_back(add_space(scene, spaces[g], false, compiled, arena));
    add_shading(scene, spaces, compiled, arena);
    if (!scene.instances.empty()) add_instances(scene, groups, compiled, arena);
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
    std::vector<bool> used(scene.materials.size()), shows_its_own(scene.groups.size());
    const auto add = [&](const Shapes &shapes) {
        for (const auto &shape : shapes) used.at(shape->material) = true;
    };
    add(scene.shapes);
    for (const PlacedGroup &instance : scene.instances) {
        if (instance.material == NO_MATERIAL)
            shows_its_own[instance.group] = true;
        else
            used.at(instance.material) = true;
    }
    for (std::size_t g = 0; g < scene.groups.size(); ++g)
        if (shows_its_own[g]) add(scene.groups[g].shapes);
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
    compiled.lights = kinds_of(scene.lights);
    compiled.header.materials = arena.add(materials);
    compiled.header.lights = arena.add(scene.lights);
}

}  // namespace

std::vector<std::size_t> groups_in_use(const Scene &scene) {
    std::set<std::size_t> used;
    for (const PlacedGroup &instance : scene.instances) used.insert(instance.group);
    return {used.begin(), used.end()};
}

CompiledScene compile(const Scene &scene) {
    CompiledScene compiled;
    compiled.warnings = scene.warnings;
    Arena arena(compiled.arena);
    add_primitives(scene, compiled, arena);
    add_materials(scene, compiled, arena);
    compiled.filter = scene.film.filter;
    compiled.header.background = scene.background;
    compiled.header.ambient = scene.ambient;
    return compiled;
}

}  // namespace brandung
