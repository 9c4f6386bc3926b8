#include "scene/accelerators/bvh2.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <optional>
#include <vector>

#include "scene/accelerators/binned_sah.h"

namespace brandung {
namespace {

constexpr uint serial_below = 4096;      ///< references of a subtree that is one task
constexpr uint partition_grain = 32768;  ///< references of a task

/// References, in one of the two lists between which they go to and fro.
struct Range {
    uint begin, end;
    uint list = 0;
    uint count() const { return end - begin; }
};

struct Build {
    BuildProgress &progress;
    LargeArray<Bvh2Node> nodes;
    LargeArray<SortedReference> lists[2];
    RelativeArea area;
    std::atomic<uint> node_count = 1;
    uint depth_limit = 0, smallest_divided = 0;

    std::span<const SortedReference> references(Range range) const { return {lists[range.list].get() + range.begin, range.count()}; }
};

/// Adding 0 makes -0 to +0: of the two, a minimum would take the one that comes first.
SortedReference sorted_reference(const Reference &reference, uint index) {
    const vec3 low = reference.bounds.low + 0.0f, high = reference.bounds.high + 0.0f;
    const float kind = float(reference.kind);
    return {.box = {Point4{low.x, low.y, low.z, kind}, Point4{high.x, high.y, high.z, kind}}, .index = index};
}

void take_references(Build &build, std::span<const Reference> references) {
    for (auto &list : build.lists) list = make_large_array<SortedReference>(references.size());
    tbb::parallel_for(size_t(0), references.size(), [&](size_t i) { build.lists[0][i] = sorted_reference(references[i], uint(i)); });
}

/// Two adjacent ranges.
struct Sides {
    uint middle;
    uint list;
    std::array<Extent, 2> extents;
};

/// Part of a range, and where what it has of either side goes.
struct Piece {
    Range range;
    std::array<uint, 2> places;
    std::array<Extent, 2> extents;
};

/// Without branches.
void move_piece(Build &build, Piece &piece, const Split &split) {
    SortedReference *to = build.lists[1 - piece.range.list].get();
    for (const SortedReference &reference : build.references(piece.range)) {
        const uint side = !split.is_first(reference);
        to[piece.places[side]++] = reference;
        piece.extents[side].add(reference);
    }
}

/// Stable. To the other list.
Sides partition(Build &build, Range range, const Split &split) {
    const uint middle = range.begin + split.first_count;
    Sides sides{.middle = middle, .list = 1 - range.list, .extents = {}};
    if (range.count() <= partition_grain) {
        Piece all{.range = range, .places = {range.begin, middle}, .extents = {}};
        move_piece(build, all, split);
        sides.extents = all.extents;
        return sides;
    }
    std::vector<Piece> pieces;
    for (uint begin = range.begin; begin < range.end; begin += partition_grain)
        pieces.push_back({.range = {begin, std::min(range.end, begin + partition_grain), range.list}, .places = {}, .extents = {}});
    tbb::parallel_for(size_t(0), pieces.size(), [&](size_t i) {
        for (const SortedReference &reference : build.references(pieces[i].range)) pieces[i].places[0] += split.is_first(reference);
    });
    uint first = range.begin, second = middle;
    for (Piece &piece : pieces) {
        const uint count = piece.places[0];
        piece.places = {first, second};
        first += count, second += piece.range.count() - count;
    }
    tbb::parallel_for(size_t(0), pieces.size(), [&](size_t i) { move_piece(build, pieces[i], split); });
    for (const Piece &piece : pieces)
        for (uint side = 0; side < 2; ++side) sides.extents[side].add(piece.extents[side]);
    return sides;
}

/// Where halves meet.
uint middle_of(Range range) {
    const uint half = range.count() / 2;
    return range.begin + (range.count() <= BLOCK_SIZE ? half : (half + BLOCK_SIZE - 1) / BLOCK_SIZE * BLOCK_SIZE);
}

/// So that blocks below come out full.
Sides halve(const Build &build, Range range) {
    const uint middle = middle_of(range);
    const Range first{range.begin, middle, range.list}, second{middle, range.end, range.list};
    return {middle, range.list, {measure(build.references(first)), measure(build.references(second))}};
}

/// Nothing if the range is best left a leaf. Halves serve where SAH finds nothing or goes too deep.
std::optional<Sides> divide(Build &build, const Bvh2Node &node, Range range, const KindBox &centres, uint depth) {
    if (node.fits_block() && node.count < build.smallest_divided) return {};
    const Split split = choose_split(build.references(range), centres, build.area);
    if (split.exists()) {
        const uint larger = std::max(split.first_count, range.count() - split.first_count);
        if (depth + 1 + depth_limit(larger, 0) <= build.depth_limit) return partition(build, range, split);
    }
    if (node.fits_block()) return {};
    return halve(build, range);
}

void build_node(Build &build, uint index, Range range, const Extent &extent, uint depth) {
    Bvh2Node &node = build.nodes[index];
    node = {extent.boxes, range.begin, range.count(), 0};
    const std::optional<Sides> sides = divide(build, node, range, extent.centres, depth);
    if (!sides) {
        if (range.list == 1) std::ranges::copy(build.references(range), build.lists[0].get() + range.begin);
        build.progress.add(range.count());
        return;
    }
    const uint children = node.children = build.node_count.fetch_add(2);
    const auto build_first = [&] { build_node(build, children, {range.begin, sides->middle, sides->list}, sides->extents[0], depth + 1); };
    const auto build_second = [&] { build_node(build, children + 1, {sides->middle, range.end, sides->list}, sides->extents[1], depth + 1); };
    if (range.count() < serial_below) {
        build_first();
        build_second();
    } else {
        tbb::parallel_invoke(build_first, build_second);
    }
}

}  // namespace

uint depth_limit(size_t references, uint slack) { return uint(std::bit_width(references - 1)) + slack; }

Bvh2 build_bvh2(std::span<const Reference> references, const Bvh2Options &options, BuildProgress &progress) {
    // Room for one leaf per reference. It isn't written beforehand, so what isn't used costs no memory.
    Build build{.progress = progress, .nodes = make_large_array<Bvh2Node>(2 * references.size()), .lists = {}, .area = {}};
    const Range all{0, uint(references.size())};
    take_references(build, references);
    const Extent extent = measure(build.references(all));
    build.area = RelativeArea(extent.boxes);
    build.depth_limit = depth_limit(references.size(), options.slack);
    build.smallest_divided = options.smallest_divided;
    build_node(build, 0, all, extent, 0);
    return {std::move(build.lists[0]), std::move(build.nodes), build.node_count, build.area};
}

}  // namespace brandung
