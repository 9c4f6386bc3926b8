#include "tests/scene/accelerators/decoded_cells.h"

#include "kernels/accelerators/octree.h"
#include "kernels/accelerators/uniform_grid.h"

namespace brandung {

std::vector<DecodedCell> decode_uniform_grid(const BuiltAccelerator &built) {
    const DecodedLists lists(built);
    const auto grid = lists.at<UniformGrid>(0);
    const auto plane = [&](int axis, uint i) { return double(grid.low[axis] + float(i) * grid.size[axis]); };
    std::vector<DecodedCell> cells;
    for (uint z = 0; z < grid.columns[2]; ++z)
        for (uint y = 0; y < grid.columns[1]; ++y)
            for (uint x = 0; x < grid.columns[0]; ++x)
                cells.push_back({{plane(0, x), plane(1, y), plane(2, z)},
                                 {plane(0, x + 1), plane(1, y + 1), plane(2, z + 1)},
                                 lists.list(lists.cell_word(cells.size()))});
    return cells;
}

namespace {

void decode_node(const DecodedLists &lists, uint word, glm::dvec3 low, double side, std::vector<DecodedCell> &cells) {
    if ((word & OCTREE_LEAF) != 0) {
        cells.push_back({low, low + side, lists.list(word == NO_ITEMS ? NO_ITEMS : word & ~OCTREE_LEAF)});
        return;
    }
    const auto node = lists.at<OctreeNode>(4 * lists.cells() + word * sizeof(OctreeNode));
    for (uint c = 0; c < 8; ++c) decode_node(lists, node.child[c], low + side / 2 * glm::dvec3(c & 1, c >> 1 & 1, c >> 2), side / 2, cells);
}

}  // namespace

std::vector<DecodedCell> decode_octree(const BuiltAccelerator &built) {
    const DecodedLists lists(built);
    const auto octree = lists.at<Octree>(0);
    std::vector<DecodedCell> cells;
    decode_node(lists, lists.at<OctreeNode>(4 * lists.cells()).child[0], octree.low, double(octree.unit) * OCTREE_UNITS, cells);
    return cells;
}

}  // namespace brandung
