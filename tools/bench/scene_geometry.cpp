#include "tools/bench/scene_geometry.h"

#include <algorithm>
#include <cstring>

#include "kernels/primitives/sphere.h"
#include "kernels/primitives/triangle.h"
#include "scene/compilation/spaces.h"
#include "scene/primitives/kinds.h"

namespace brandung {
namespace {

template <class Record> Record record_in(const CompiledScene &compiled, const Span &span, std::size_t i) {
    Record record;
    std::memcpy(&record, compiled.arena.data() + std::size_t{64} * span.offset + i * sizeof record, sizeof record);
    return record;
}

template <class View> View view_of(const ShadingRecord &record) {
    View view;
    std::memcpy(&view, record.words, sizeof view);
    return view;
}

/// The primitive in the next free lane of those of its kind.
GeometryPrimitive add_other(std::vector<OtherPrimitives> &others, const PrimitiveOf &primitive) {
    const PrimitiveKind &kind = primitive.shape->kind();
    auto place = std::ranges::find_if(others, [&](const OtherPrimitives &each) { return &each.oracle->kind() == &kind; });
    if (place == others.end()) {
        const auto &all = primitive_oracles();
        const auto oracle = std::ranges::find_if(all, [&](const PrimitiveOracle *each) { return &each->kind() == &kind; });
        place = others.insert(place, OtherPrimitives{.oracle = *oracle, .blocks = {}});
    }
    const uint lane = place->count++;
    place->blocks.resize((lane / BLOCK_SIZE + 1) * kind.block_bytes);
    primitive.shape->write_lane(primitive.i, lane % BLOCK_SIZE, place->blocks.data() + lane / BLOCK_SIZE * kind.block_bytes);
    return {GeometryPrimitive::Kind::other, {}, {}, {}, static_cast<uint>(place - others.begin()), lane};
}

GeometryPrimitive primitive_of(SceneGeometry &geometry, const CompiledScene &compiled, std::size_t i, const PrimitiveOf &primitive) {
    const auto record = record_in<ShadingRecord>(compiled, compiled.header.shading, i);
    const PrimitiveKind *kind = compiled.primitives[record.kind];
    if (kind == &triangle_kind || kind == &smooth_triangle_kind) {
        const auto triangle = view_of<TriangleShading>(record);
        return {GeometryPrimitive::Kind::triangle, triangle.a, triangle.b, triangle.c};
    }
    if (kind != &sphere_kind) return add_other(geometry.others, primitive);
    const auto sphere = view_of<SphereShading>(record);
    return {GeometryPrimitive::Kind::sphere, sphere.center, {sphere.radius, 0, 0}, {}};
}

}  // namespace

bool SceneGeometry::has(GeometryPrimitive::Kind kind) const {
    return std::ranges::find(primitives, kind, &GeometryPrimitive::kind) != primitives.end();
}

std::size_t SceneGeometry::space_of(uint instance) const { return instance == 0 ? 0 : instances[instance].group + 1; }

SceneGeometry geometry_of(const Scene &scene, const CompiledScene &compiled) {
    SceneGeometry geometry;
    for (const Space &space : spaces_in_use(scene)) {
        geometry.spaces.push_back({space.first, space.first + static_cast<uint>(space.primitives.size())});
        for (const PrimitiveOf &primitive : space.primitives)
            geometry.primitives.push_back(primitive_of(geometry, compiled, geometry.primitives.size(), primitive));
    }
    if (!compiled.instances) return geometry;
    for (std::size_t i = 0; i <= compiled.instance_count; ++i)
        geometry.instances.push_back(record_in<Instance>(compiled, compiled.header.instances, i));
    return geometry;
}

}  // namespace brandung
