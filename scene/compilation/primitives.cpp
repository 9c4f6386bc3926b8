#include <algorithm>
#include <chrono>
#include <cstring>
#include <optional>

#include "kernels/core/items.h"
#include "kernels/primitives/instance.h"
#include "scene/accelerators/accelerator.h"
#include "scene/compilation/parts.h"
#include "scene/compilation/spaces.h"
#include "scene/error.h"
#include "scene/places.h"
#include "scene/warnings.h"

namespace brandung {
namespace {

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

/// `space` is that of the first shape which lacks them.
void warn_of_lacking_uvs(const Scene &scene, std::size_t space, const Shape &shape, std::size_t triangles, CompiledScene &compiled) {
    compiled.warnings["triangle with a texture, but without texture coordinates: has the colour at (0, 0)"] = static_cast<uint>(triangles);
    const std::optional<std::size_t> group = space == 0 ? std::nullopt : std::optional(groups_in_use(scene)[space - 1]);
    place_warnings(compiled, [&] { return place_of_shape(scene, group, shape); });
}

void add_shading(const Scene &scene, const std::vector<Space> &spaces, CompiledScene &compiled, Arena &arena) {
    std::vector<ShadingRecord> shading;
    SharedTables tables;
    compiled.counts.resize(compiled.primitives.size());
    std::optional<std::pair<std::size_t, const Shape *>> lacks_uvs;  // the first one's space, and itself
    for (std::size_t s = 0; s < spaces.size(); ++s) {
        for (const PrimitiveOf &primitive : spaces[s].primitives) {
            const uint kind = number_of(compiled.primitives, primitive.shape->kind());
            ++compiled.counts[kind];
            tables.wants_uvs = spaces[s].is_textured || is_textured(scene.materials.at(primitive.shape->material).record);
            ShadingRecord &record = shading.emplace_back(ShadingRecord{kind, primitive.shape->material, {}});
            primitive.shape->write_shading(primitive.i, record.words, tables);
            if (tables.lack_uvs > 0 && !lacks_uvs) lacks_uvs.emplace(s, primitive.shape);
        }
    }
    compiled.primitive_count = shading.size();
    compiled.header.shading = arena.add(shading);
    compiled.header.vertex_normals = arena.add(tables.vertex_normals);
    compiled.header.vertex_uvs = arena.add(tables.vertex_uvs);
    compiled.header.vertex_colors = arena.add(tables.vertex_colors);
    compiled.tints |= !tables.vertex_colors.empty();
    if (lacks_uvs) warn_of_lacking_uvs(scene, lacks_uvs->first, *lacks_uvs->second, tables.lack_uvs, compiled);
    compiled.shading_normals = !tables.vertex_normals.empty();
}

/// The accelerator of a space, over its primitives and, in the world, the instances.
Group add_space(const Scene &scene, const Space &space, bool is_world, const WatchAccelerator &watch, CompiledScene &compiled, Arena &arena) {
    const uint kinds = static_cast<uint>(compiled.primitives.size());
    std::vector<Reference> references;
    references.reserve(space.primitives.size());
    for (const PrimitiveOf &primitive : space.primitives)
        references.push_back({primitive.shape->bounds(primitive.i), number_of(compiled.primitives, primitive.shape->kind())});
    if (is_world)
        for (const PlacedGroup &instance : scene.instances) references.push_back({instance.bounds, kinds});

    const auto start = std::chrono::steady_clock::now();
    const AcceleratorKind &kind = *compiled.accelerator;
    BuildProgress progress = watch ? BuildProgress([&](double part) { watch(kind, part); }) : BuildProgress();
    const Hulls hulls = [&](uint i) {
        return i < space.primitives.size() ? space.primitives[i].shape->hull(space.primitives[i].i) : hull_of_box(references[i].bounds);
    };
    const BuiltAccelerator built = kind.build(references, hulls, progress);
    compiled.accelerator_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    Group group{};
    group.extent = extent_of(references);
    const auto add_blocks = [&](uint k, const std::vector<std::byte> &records) {
        group.blocks[k] = arena.add(records, built.blocks[k].size());
        compiled.block_bytes += records.size();
    };
    for (uint k = 0; k < kinds; ++k) add_blocks(k, write_primitives(*compiled.primitives[k], built.blocks[k], space));
    if (is_world && !scene.instances.empty()) add_blocks(kinds, write_instances(built.blocks[kinds], scene, space.primitives.size()));
    group.nodes = arena.add(built.nodes, built.node_count);
    compiled.node_bytes += built.nodes.size();
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

}  // namespace

void add_primitives(const Scene &scene, const CompileOptions &options, CompiledScene &compiled, Arena &arena) {
    const std::vector<Space> spaces = spaces_in_use(scene);
    compiled.accelerator = options.accelerator ? options.accelerator : &find_accelerator(scene.accelerator);
    compiled.primitives = options.kinds == Kinds::all ? primitive_kinds() : primitive_kinds_in_use(scene);
    compiled.instances = options.kinds == Kinds::all || !scene.instances.empty();
    if (compiled.primitives.size() + (compiled.instances ? 1 : 0) > MAX_PRIMITIVE_KINDS)
        throw SceneError(scene.file + ": too many kinds of primitives in one scene");
    compiled.header.world = add_space(scene, spaces.front(), true, options.watch, compiled, arena);
    std::vector<Group> groups;
    for (std::size_t g = 1; g < spaces.size(); ++g) groups.push_back(add_space(scene, spaces[g], false, options.watch, compiled, arena));
    add_shading(scene, spaces, compiled, arena);
    if (compiled.instances) add_instances(scene, groups, compiled, arena);
}

}  // namespace brandung
