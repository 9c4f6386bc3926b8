/// Divides a cube into eight wherever that saves tests.
#include "kernels/accelerators/octree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <memory>
#include <numeric>

#include "scene/accelerators/cell_lists.h"

namespace brandung {
namespace {

constexpr double step_cost = 8;            ///< of a cell that a ray comes to, in tests of one reference; 4 and 16 are hardly slower on the SPD scenes
constexpr double most_per_reference = 16;  ///< entries in lists, on average
constexpr std::size_t serial_below = 2048;  ///< references of a cell that is one task

/// In units of the octree: from low to before high, at least one unit.
struct UnitBox {
    std::array<uint, 3> low, high;
};

/// A cell while it is built.
struct OctreeCell {
    std::array<std::unique_ptr<OctreeCell>, 8> children;  ///< all or none
    std::vector<uint> members;                            ///< of a leaf
    bool is_leaf() const { return !children[0]; }
};

struct Cube {
    std::array<uint, 3> low;
    uint side;

    Cube child(uint c) const {
        const uint half = side / 2;
        return {{low[0] + (c & 1) * half, low[1] + (c >> 1 & 1) * half, low[2] + (c >> 2) * half}, half};
    }
    bool meets(const UnitBox &box) const {
        for (uint axis = 0; axis < 3; ++axis)
            if (box.low[axis] >= low[axis] + side || box.high[axis] <= low[axis]) return false;
        return true;
    }
};

/// The root holds all boxes: its side is as long as theirs together, or the least that a float in this place tells from nothing.
Octree octree_around(std::span<const Reference> references) {
    const Bounds bounds = bounds_of(references);
    Octree octree{};
    octree.low = bounds.low;
    float side = FLT_MIN * float(OCTREE_UNITS);
    for (int axis = 0; axis < 3; ++axis) {
        side = std::max(side, bounds.high[axis] - bounds.low[axis]);
        while (double(bounds.low[axis]) + side < bounds.high[axis]) side = std::nextafter(side, FLT_MAX);
    }
    octree.unit = side / float(OCTREE_UNITS);
    return octree;
}

/// Outward to whole units; what rounding of the quotients loses is far less than the unit by which rays reach farther than they must.
UnitBox in_units(const Octree &octree, const Bounds &bounds) {
    UnitBox box;
    const double last = OCTREE_UNITS - 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = (double(bounds.low[axis]) - octree.low[axis]) / octree.unit,
                     high = (double(bounds.high[axis]) - octree.low[axis]) / octree.unit;
        box.low[size_t(axis)] = uint(std::clamp(std::floor(low), 0.0, last));
        box.high[size_t(axis)] = uint(std::clamp(std::ceil(high), box.low[size_t(axis)] + 1.0, last + 1));
    }
    return box;
}

class OctreeBuild {
public:
    OctreeBuild(std::vector<UnitBox> boxes, BuildProgress &progress) : boxes_(std::move(boxes)), progress_(progress) {}

    std::unique_ptr<OctreeCell> build() {
        std::vector<uint> all(boxes_.size());
        std::iota(all.begin(), all.end(), 0u);
        return build({{0, 0, 0}, OCTREE_UNITS}, std::move(all), 0, most_per_reference * double(boxes_.size()));
    }

private:
    /// `entries`: what the lists below may have in all.
    std::unique_ptr<OctreeCell> build(Cube cube, std::vector<uint> members, uint depth, double entries) const {
        auto cell = std::make_unique<OctreeCell>();
        std::array<std::vector<uint>, 8> parts;
        if (depth == OCTREE_DEPTH || members.size() < 2 || !divide(cube, members, entries, parts)) {
            progress_.add(std::uint64_t(entries));  // the cell's share of the work, too
            cell->members = std::move(members);
            return cell;
        }
        const double share = entries / double(sum(parts));
        const bool serial = members.size() < serial_below;
        members = {};
        const auto build_child = [&](uint c) {
            const double of_child = share * double(parts[c].size());
            cell->children[c] = build(cube.child(c), std::move(parts[c]), depth + 1, of_child);
        };
        if (serial)
            for (uint c = 0; c < 8; ++c) build_child(c);
        else
            tbb::parallel_for(0u, 8u, build_child);
        return cell;
    }

    static std::size_t sum(const std::array<std::vector<uint>, 8> &parts) {
        std::size_t sum = 0;
        for (const auto &part : parts) sum += part.size();
        return sum;
    }

    /// Whether it pays. Of the rays through a cube one in four comes through each of its octants: the ratio of surfaces (MacDonald and Booth,
    /// Heuristics for Ray Tracing Using Space Subdivision, The Visual Computer 6(3) 1990).
    bool divide(Cube cube, const std::vector<uint> &members, double entries, std::array<std::vector<uint>, 8> &parts) const {
        for (uint c = 0; c < 8; ++c) {
            const Cube child = cube.child(c);
            for (const uint member : members)
                if (child.meets(boxes_[member])) parts[c].push_back(member);
        }
        const double below = double(sum(parts));
        return below <= entries && 2 * step_cost + below / 4 < double(members.size());
    }

    std::vector<UnitBox> boxes_;
    BuildProgress &progress_;
};

/// Depth first: nodes and the lists of leaves, in the order of their places.
struct Flattened {
    std::vector<OctreeNode> nodes;
    Cells cells{.starts = {0}, .members = {}};
};

/// A leaf's word counts leaves, until their lists have places.
uint flatten(const OctreeCell &cell, Flattened &flat) {
    if (cell.is_leaf()) {
        if (cell.members.empty()) return NO_ITEMS;
        check_entries(flat.cells.members.size() + cell.members.size(), "octree");
        flat.cells.members.insert(flat.cells.members.end(), cell.members.begin(), cell.members.end());
        flat.cells.starts.push_back(uint(flat.cells.members.size()));
        return OCTREE_LEAF | uint(flat.cells.count() - 1);
    }
    const uint place = uint(flat.nodes.size());
    flat.nodes.push_back({});
    for (uint c = 0; c < 8; ++c) {
        const uint word = flatten(*cell.children[c], flat);
        flat.nodes[place].child[c] = word;
    }
    return place;
}

}  // namespace

BuiltAccelerator build_octree(std::span<const Reference> references, const Hulls &, BuildQuality, BuildProgress &progress) {
    progress.begin(std::uint64_t(most_per_reference * double(references.size())));
    const Octree octree = octree_around(references);
    std::vector<UnitBox> boxes(references.size());
    tbb::parallel_for(std::size_t(0), references.size(), [&](std::size_t i) { boxes[i] = in_units(octree, references[i].bounds); });
    const std::unique_ptr<OctreeCell> root = OctreeBuild(std::move(boxes), progress).build();
    Flattened flat;
    flat.nodes.push_back({});
    const uint word = flatten(*root, flat);
    std::fill(std::begin(flat.nodes[0].child), std::end(flat.nodes[0].child), word);
    CellLists lists = list_cells(references, flat.cells, "octree");
    for (OctreeNode &node : flat.nodes)
        for (uint &child : node.child)
            if (child != NO_ITEMS && (child & OCTREE_LEAF) != 0) child = OCTREE_LEAF | lists.lists[child & ~OCTREE_LEAF];
    return built_of_cells(octree, flat.nodes, std::move(lists));
}

}  // namespace brandung
