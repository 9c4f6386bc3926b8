#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <optional>

#include "kernels/primitives/instance.h"
#include "kernels/primitives/motion.h"
#include "scene/accelerators/accelerator.h"
#include "scene/compilation/parts.h"
#include "scene/compilation/sizes.h"
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
Span add_blocks(const std::vector<PrimitiveBlock> &blocks, std::size_t block_bytes, Arena &arena, const WriteLane &write_lane) {
    const auto [span, bytes] = arena.make(blocks.size() * block_bytes, blocks.size());
    std::byte *records = bytes.data();
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
        std::byte *record = records + b * block_bytes;
        std::fill_n(record, block_bytes, std::byte{0xff});
        for (uint lane = 0; lane < blocks[b].count; ++lane) write_lane(blocks[b].references[lane], lane, record);
    });
    return span;
}

Span add_blocks_of(const PrimitiveKind &kind, const std::vector<PrimitiveBlock> &blocks, const Space &space, Arena &arena) {
    return add_blocks(blocks, kind.block_bytes, arena, [&](uint reference, uint lane, std::byte *block) {
        const uint number = space.first + reference;
        std::memcpy(block + lane * sizeof(uint), &number, sizeof number);
        space.primitives[reference].shape->write_lane(space.primitives[reference].i, lane, block);
    });
}

/// Instances are numbered from 1 on; their references follow those of the world's primitives.
Span add_instance_blocks(const std::vector<PrimitiveBlock> &blocks, const Scene &scene, std::size_t first_reference, Arena &arena) {
    return add_blocks(blocks, sizeof(InstanceBlock), arena, [&](uint reference, uint lane, std::byte *bytes) {
        InstanceBlock &block = *reinterpret_cast<InstanceBlock *>(bytes);
        const std::size_t i = reference - first_reference;
        block.primitive[lane] = static_cast<uint>(i + 1);
        for (int axis = 0; axis < 3; ++axis) {
            block.low[axis][lane] = scene.instances[i].bounds.low[axis];
            block.high[axis][lane] = scene.instances[i].bounds.high[axis];
        }
    });
}

/// Largest magnitude of a coordinate.
float extent_of(const std::vector<Reference> &references) {
    const auto of_range = [&](const tbb::blocked_range<std::size_t> &range, float largest) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            if (references[i].bounds.empty()) continue;
            const vec3 corner = glm::max(glm::abs(references[i].bounds.low), glm::abs(references[i].bounds.high));
            largest = std::max({largest, corner.x, corner.y, corner.z});
        }
        return largest;
    };
    return tbb::parallel_reduce(tbb::blocked_range<std::size_t>(0, references.size()), 0.0f, of_range,
                                [](float a, float b) { return std::max(a, b); });
}

template <class Record> std::size_t bytes_of(const std::vector<Record> &records) { return records.size() * sizeof(Record); }

/// `space` is that of the first shape which lacks them.
void warn_of_lacking_uvs(const Scene &scene, std::size_t space, const Shape &shape, std::size_t triangles, CompiledScene &compiled) {
    compiled.warnings["triangle with a texture, but without texture coordinates: has the colour at (0, 0)"] = static_cast<uint>(triangles);
    const std::optional<std::size_t> group = space == 0 ? std::nullopt : std::optional(groups_in_use(scene)[space - 1]);
    place_warnings(compiled, [&] { return place_of_shape(scene, group, shape); });
}

void add_shading(const Scene &scene, const std::vector<Space> &spaces, CompiledScene &compiled, Arena &arena) {
    const auto [span, room] = arena.make(compiled.primitive_count * sizeof(ShadingRecord), compiled.primitive_count);
    ShadingRecord *record = reinterpret_cast<ShadingRecord *>(room.data());
    SharedTables tables;
    compiled.counts.resize(compiled.primitives.size());
    std::optional<std::pair<std::size_t, const Shape *>> lacks_uvs;  // the first one's space, and itself
    for (std::size_t s = 0; s < spaces.size(); ++s) {
        for (const PrimitiveOf &primitive : spaces[s].primitives) {
            const uint kind = number_of(compiled.primitives, primitive.shape->kind());
            ++compiled.counts[kind];
            tables.wants_uvs = spaces[s].is_textured || is_textured(scene, primitive.shape->material);
            record->kind = kind, record->material = primitive.shape->material;
            primitive.shape->write_shading(primitive.i, record->words, tables);
            ++record;
            if (tables.lack_uvs > 0 && !lacks_uvs) lacks_uvs.emplace(s, primitive.shape);
        }
    }
    compiled.header.shading = span;
    compiled.header.vertex_normals = arena.add(tables.vertex_normals);
    compiled.header.vertex_uvs = arena.add(tables.vertex_uvs);
    compiled.header.vertex_colors = arena.add(tables.vertex_colors);
    compiled.shading_bytes = room.size() + bytes_of(tables.vertex_normals) + bytes_of(tables.vertex_uvs) + bytes_of(tables.vertex_colors);
    compiled.tints |= !tables.vertex_colors.empty();
    if (lacks_uvs) warn_of_lacking_uvs(scene, lacks_uvs->first, *lacks_uvs->second, tables.lack_uvs, compiled);
    compiled.shading_normals = !tables.vertex_normals.empty();
}

/// What a builder is given of a space: its primitives and, in the world, the instances.
std::vector<Reference> references_of(const Scene &scene, const Space &space, bool is_world, const std::vector<const PrimitiveKind *> &kinds) {
    std::vector<Reference> references(space.primitives.size());
    tbb::parallel_for(std::size_t{0}, references.size(), [&](std::size_t i) {
        const auto [shape, place] = space.primitives[i];
        references[i] = {shape->bounds(place), number_of(kinds, shape->kind())};
    });
    if (is_world)
        for (const PlacedGroup &instance : scene.instances) references.push_back({instance.bounds, static_cast<uint>(kinds.size())});
    return references;
}

/// The accelerator of a space, which is built from its shapes until its nodes and blocks are in the arena.
Group add_space(const Scene &scene, const Space &space, bool is_world, const WatchAccelerator &watch, CompiledScene &compiled, Arena &arena) {
    const auto start = std::chrono::steady_clock::now();
    const uint kinds = static_cast<uint>(compiled.primitives.size());
    const std::vector<Reference> references = references_of(scene, space, is_world, compiled.primitives);
    const AcceleratorKind &kind = *compiled.accelerator;
    BuildProgress progress = watch ? BuildProgress([&](double part) { watch(kind, part); }) : BuildProgress();
    const Hulls hulls = [&](uint i) {
        return i < space.primitives.size() ? space.primitives[i].shape->hull(space.primitives[i].i) : hull_of_box(references[i].bounds);
    };
    const BuiltAccelerator built = kind.build(references, hulls, scene.accelerator_quality, progress);
    if (is_world) compiled.blocks_at_root = built.blocks_at_root;

    Group group{};
    group.extent = extent_of(references);
    for (uint k = 0; k < kinds; ++k) {
        group.blocks[k] = add_blocks_of(*compiled.primitives[k], built.blocks[k], space, arena);
        compiled.block_bytes += built.blocks[k].size() * compiled.primitives[k]->block_bytes;
    }
    if (is_world && !scene.instances.empty()) {
        group.blocks[kinds] = add_instance_blocks(built.blocks[kinds], scene, space.primitives.size(), arena);
        compiled.block_bytes += built.blocks[kinds].size() * sizeof(InstanceBlock);
    }
    group.nodes = arena.add(built.nodes, built.node_count);
    compiled.node_bytes += built.nodes.size();
    compiled.accelerator_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return group;
}

/// Their groups are numbered among those in use.
void add_instances(const Scene &scene, const std::vector<Group> &groups, CompiledScene &compiled, Arena &arena) {
    const std::vector<std::size_t> used = groups_in_use(scene);
    const Transform identity = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
    std::vector<Instance> instances = {Instance{identity, identity, 0, NO_MATERIAL, 0, 0, {}}};
    std::vector<MotionPart> motion_parts;
    for (const PlacedGroup &placed : scene.instances) {
        const uint group = static_cast<uint>(place_in(used, placed.group));
        const auto first_part = static_cast<uint>(motion_parts.size()), parts = static_cast<uint>(placed.motion.size());
        instances.push_back({placed.transforms.to_world, placed.transforms.to_group, group, placed.material, first_part, parts, {}});
        motion_parts.insert(motion_parts.end(), placed.motion.begin(), placed.motion.end());
    }
    compiled.header.groups = arena.add(groups);
    compiled.header.instances = arena.add(instances);
    compiled.header.motion_parts = arena.add(motion_parts);
    compiled.moves = !motion_parts.empty();
    compiled.group_count = groups.size();
    compiled.instance_count = scene.instances.size();
}

}  // namespace

void add_primitives(const Scene &scene, const CompileOptions &options, CompiledScene &compiled, Arena &arena) {
    const LeastSizes sizes = least_sizes(scene);
    expect_to_fit(scene, sizes, options.limit);
    compiled.primitive_count = sizes.primitives;
    arena.reserve(sizes.all() + sizes.all() / 2);  // what isn't used takes no memory
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
