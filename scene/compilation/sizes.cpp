#include "scene/compilation/sizes.h"

#include <fmt/format.h>

#include <map>

#include "kernels/core/items.h"
#include "scene/error.h"

namespace brandung {
namespace {

std::string mebibytes(std::size_t bytes) { return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1 << 20)); }

std::string limit_text(const ArenaLimit &limit) {
    return fmt::format("one allocation of '{}' takes {} at most", limit.device, mebibytes(limit.bytes));
}

}  // namespace

LeastSizes least_sizes(const Scene &scene) {
    LeastSizes sizes;
    for (const Shapes *shapes : shapes_in_use(scene)) {
        std::map<const PrimitiveKind *, std::size_t> counts;  // of this space: blocks hold primitives of one
        for (const auto &shape : *shapes) counts[&shape->kind()] += shape->count();
        for (const auto &[kind, count] : counts) {
            sizes.primitives += count;
            sizes.blocks += (count + BLOCK_SIZE - 1) / BLOCK_SIZE * kind->block_bytes;
            sizes.shading += count * (sizeof(ShadingRecord) + kind->table_bytes);
        }
    }
    if (sizes.primitives > MAX_PRIMITIVES)
        throw SceneError(fmt::format("{}: {} primitives are too many: at most {} have numbers", scene.file, sizes.primitives, MAX_PRIMITIVES));
    return sizes;
}

void expect_to_fit(const Scene &scene, const LeastSizes &sizes, const ArenaLimit &limit) {
    if (sizes.all() <= limit.bytes) return;
    throw SceneError(fmt::format("{}: {} primitives take at least {} ({} of blocks, {} of shading records); {}", scene.file, sizes.primitives,
                                 mebibytes(sizes.all()), mebibytes(sizes.blocks), mebibytes(sizes.shading), limit_text(limit)));
}

void expect_to_fit(const Scene &scene, const CompiledScene &compiled, const ArenaLimit &limit) {
    const std::size_t all = compiled.arena.size(), counted = compiled.block_bytes + compiled.node_bytes + compiled.shading_bytes;
    if (all <= limit.bytes) return;
    throw SceneError(fmt::format("{}: {} primitives and {} instances take {} ({} of blocks, {} of nodes, {} of shading records, {} of others); {}",
                                 scene.file, compiled.primitive_count, compiled.instance_count, mebibytes(all), mebibytes(compiled.block_bytes),
                                 mebibytes(compiled.node_bytes), mebibytes(compiled.shading_bytes), mebibytes(all - counted), limit_text(limit)));
}

}  // namespace brandung
