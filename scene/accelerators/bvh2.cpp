#include "scene/accelerators/bvh2.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <bit>

#include "scene/accelerators/binned_sah.h"

namespace brandung {
namespace {

constexpr uint serial_below = 4096;   ///< references of a subtree that is one task
constexpr uint smallest_divided = 5;  ///< offering smaller blocks in pieces gains next to nothing

struct Range {
    uint begin, end;
    uint count() const { return end - begin; }
};

struct Build {
    BuildProgress &progress;
    Bvh2 tree{};
    std::vector<SortedReference> scratch{};
    std::atomic<uint> node_count = 1;
    uint depth_limit = 0;

    std::span<const SortedReference> references(Range range) const { return std::span(tree.references).subspan(range.begin, range.count()); }
};

uint ceil_log2(size_t count) { return uint(std::bit_width(count - 1)); }

/// Adding 0 makes -0 to +0: of the two, a minimum would take the one that comes first.
SortedReference sorted_reference(const Reference &reference, uint index) {
    const vec3 low = reference.bounds.low + 0.0f, high = reference.bounds.high + 0.0f;
    const float kind = float(reference.kind);
    return {.box = {{low.x, low.y, low.z, kind}, {high.x, high.y, high.z, kind}}, .index = index};
}

void take_references(Build &build, std::span<const Reference> references) {
    build.tree.references.resize(references.size());
    build.scratch.resize(references.size());
    tbb::parallel_for(size_t(0), references.size(), [&](size_t i) { build.tree.references[i] = sorted_reference(references[i], uint(i)); });
}

/// Stable and without branches. Gives the end of the first side.
uint partition(Build &build, Range range, const Split &split) {
    std::vector<SortedReference> &references = build.tree.references;
    uint first = range.begin, second = range.begin;
    for (uint i = range.begin; i < range.end; ++i) {
        const SortedReference reference = references[i];
        const bool is_first = split.is_first(reference);
        references[first] = reference;
        build.scratch[second] = reference;
        first += is_first;
        second += !is_first;
    }
    std::copy(build.scratch.begin() + range.begin, build.scratch.begin() + second, references.begin() + first);
    return first;
}

/// Where halves meet, so that blocks below come out full.
uint middle_of(Range range) {
    const uint half = range.count() / 2;
    return range.begin + (range.count() <= BLOCK_SIZE ? half : (half + BLOCK_SIZE - 1) / BLOCK_SIZE * BLOCK_SIZE);
}

/// Where the second of two children begins, range.begin if the range is best left a leaf. Halves serve where SAH finds nothing or goes too deep.
uint divide(Build &build, const Bvh2Node &node, const KindBox &centres, uint depth) {
    const Range range{node.first, node.first + node.count};
    if (node.fits_block() && node.count < smallest_divided) return range.begin;
    const Split split = choose_split(build.references(range), centres, build.tree.pad);
    if (split.exists()) {
        const uint middle = partition(build, range, split);
        const uint larger = std::max(middle - range.begin, range.end - middle);
        if (depth + 1 + ceil_log2(larger) <= build.depth_limit) return middle;
    }
    return node.fits_block() ? range.begin : middle_of(range);
}

void build_node(Build &build, uint index, Range range, uint depth) {
    const Extent extent = measure(build.references(range));
    Bvh2Node &node = build.tree.nodes[index];
    node = {extent.boxes, range.begin, range.count(), 0};
    const uint middle = divide(build, node, extent.centres, depth);
    if (middle == range.begin) {
        build.progress.add(range.count());
        return;
    }
    const uint children = node.children = build.node_count.fetch_add(2);
    const auto build_first = [&] { build_node(build, children, {range.begin, middle}, depth + 1); };
    const auto build_second = [&] { build_node(build, children + 1, {middle, range.end}, depth + 1); };
    if (range.count() < serial_below) {
        build_first();
        build_second();
    } else {
        tbb::parallel_invoke(build_first, build_second);
    }
}

/// Far below what a float can resolve of the scene, but enough to tell short lines from long ones.
double pad_for(const KindBox &box) {
    double extent = 1e-25;
    for (uint axis = 0; axis < kind_axis; ++axis) extent = std::max(extent, double(box.high[axis]) - box.low[axis]);
    return extent * 0x1p-40;
}

}  // namespace

Bvh2 build_bvh2(std::span<const Reference> references, uint slack, BuildProgress &progress) {
    Build build{.progress = progress};
    const Range all{0, uint(references.size())};
    take_references(build, references);
    // Room for one leaf per reference. It isn't written beforehand, so what isn't used costs no memory.
    build.tree.nodes = std::make_unique_for_overwrite<Bvh2Node[]>(2 * references.size());
    build.tree.pad = pad_for(measure(build.references(all)).boxes);
    build.depth_limit = ceil_log2(references.size()) + slack;
    build_node(build, 0, all, 0);
    build.tree.node_count = build.node_count;
    return std::move(build.tree);
}

}  // namespace brandung
