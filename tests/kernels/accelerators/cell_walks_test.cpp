/// Walks through cells come to every cell that the ray's own box test meets before t_max, and to each once: in planes of cells, along edges, through
/// corners, from there, and with components that are 0 or -0.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ostream>
#include <set>

#include "kernels/accelerators/kd_tree.h"
#include "kernels/accelerators/octree.h"
#include "kernels/accelerators/uniform_grid.h"
#include "scene/bounds.h"
#include "tests/support/probe.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_scene.h"

namespace brandung {
namespace {

constexpr uint most_visits = 1024;
struct Visits {
    uint count;
    uint cells[most_visits];
};

/// Cells, whose lists are their own numbers, as a structure's walk finds them.
struct CellsUnderTest {
    std::vector<uint> words;  ///< header and cells
    std::vector<Bounds> cells;
    Bounds whole;

    template <class Record> void append(const Record &record) {
        const std::size_t place = words.size();
        words.resize(place + sizeof record / sizeof(uint));
        std::memcpy(words.data() + place, &record, sizeof record);
    }
};

struct Structure {
    const char *name, *file;  ///< kernels/accelerators/<file>_walk.cl
    CellsUnderTest (*make)();
    double reach;  ///< beyond the pad, in pads: how far cells that it comes to may be from the ray
};
void PrintTo(const Structure &structure, std::ostream *out) { *out << structure.name; }

CellsUnderTest grid_of(vec3 low, vec3 size) {
    const UniformGrid grid{{sizeof(UniformGrid) / sizeof(uint), 0, 0}, low, size, {5, 3, 4}};
    CellsUnderTest under_test;
    under_test.append(grid);
    for (uint z = 0; z < grid.columns[2]; ++z)
        for (uint y = 0; y < grid.columns[1]; ++y)
            for (uint x = 0; x < grid.columns[0]; ++x) {
                const auto corner = [&](uint more) { return grid.low + vec3(x + more, y + more, z + more) * grid.size; };
                under_test.append(uint(under_test.cells.size()));
                under_test.cells.push_back({corner(0), corner(1)});
                under_test.whole.add(under_test.cells.back());
            }
    return under_test;
}

CellsUnderTest uniform_grid() { return grid_of({-1, 0.25f, -0.7f}, {0.4f, 0.5f, 0.3f}); }
/// Where floats are 2^-10 apart: some cells are flat, and all are thinner than the pad.
CellsUnderTest fine_grid() { return grid_of({8192, 8200, 8190}, {3e-4f, 4e-4f, 1e-3f}); }

/// Divides every third octant again, `depth` times.
uint add_octant(std::vector<OctreeNode> &nodes, std::vector<Bounds> &cells, const Bounds &bounds, uint depth, uint &turn) {
    if (depth == 0 || turn++ % 3 != 0) {
        cells.push_back(bounds);
        return OCTREE_LEAF | uint(cells.size() - 1);
    }
    const uint place = uint(nodes.size());
    nodes.emplace_back();
    const vec3 half = 0.5f * (bounds.high - bounds.low);
    for (uint c = 0; c < 8; ++c) {
        const vec3 low = bounds.low + half * vec3(c & 1, c >> 1 & 1, c >> 2);
        const uint word = add_octant(nodes, cells, {low, low + half}, depth - 1, turn);
        nodes[place].child[c] = word;
    }
    return place;
}

/// Its planes are floats: halves of a power of two.
CellsUnderTest octree() {
    CellsUnderTest under_test;
    const Octree octree{{sizeof(Octree) / sizeof(uint), 0, 0}, {-1, 0.5f, -0.75f}, 2.0f / OCTREE_UNITS};
    under_test.append(octree);
    under_test.whole = {octree.low, octree.low + 2.0f};
    std::vector<OctreeNode> nodes(1);
    uint turn = 0;
    const uint root = add_octant(nodes, under_test.cells, under_test.whole, 4, turn);
    std::fill(std::begin(nodes[0].child), std::end(nodes[0].child), root);
    for (const OctreeNode &node : nodes) under_test.append(node);
    return under_test;
}

/// Planes anywhere, some twice at one place: what is between them is flat.
void divide(std::vector<KdNode> &nodes, std::vector<Bounds> &cells, uint place, const Bounds &bounds, uint depth, Random &random) {
    if (depth == 0) {
        nodes[place] = {uint(cells.size()), KD_LEAF};
        cells.push_back(bounds);
        return;
    }
    const int axis = int(random.below(3));
    const float plane = random.below(6) == 0 ? bounds.low[axis] : random.uniform(bounds.low[axis], bounds.high[axis]);
    const uint children = uint(nodes.size());
    nodes.resize(nodes.size() + 2);
    std::memcpy(&nodes[place].plane, &plane, sizeof plane);
    nodes[place].word = uint(axis) | children << KD_CHILD_SHIFT;
    Bounds below = bounds, above = bounds;
    below.high[axis] = above.low[axis] = plane;
    divide(nodes, cells, children, below, depth - 1, random), divide(nodes, cells, children + 1, above, depth - 1, random);
}

CellsUnderTest kd_tree() {
    CellsUnderTest under_test;
    under_test.whole = {{-1, 0.25f, -0.7f}, {1.3f, 2, 1.1f}};
    under_test.append(KdTree{{sizeof(KdTree) / sizeof(uint), 0, 0}, under_test.whole.low, under_test.whole.high});
    std::vector<KdNode> nodes(2);
    Random random(2);
    divide(nodes, under_test.cells, 0, under_test.whole, 6, random);
    for (const KdNode &node : nodes) under_test.append(node);
    return under_test;
}

float extent_of(const Bounds &box) {
    const vec3 most = glm::max(glm::abs(box.low), glm::abs(box.high));
    return std::max({most.x, most.y, most.z});
}

struct Stretch {
    float near, far;
};

/// The test of kernels/core/lane_ray.cl, grown by further pads: where the ray is in the box before t_max.
Stretch stretch_in(const Ray &ray, const Bounds &box, float extent, double further) {
    const vec3 o = glm::abs(ray.origin), d = glm::abs(ray.direction);
    const float pad = 0x1p-20f * (std::max({o.x, o.y, o.z}) + extent), grown = pad * float(1 + further);
    const float tiny = 0x1p-60f * std::max({d.x, d.y, d.z});
    float near = 0, far = ray.t_max;
    for (int axis = 0; axis < 3; ++axis) {
        const float direction = d[axis] < tiny ? std::copysign(tiny, ray.direction[axis]) : ray.direction[axis], inverse = 1 / direction;
        const float shift_low = -((ray.origin[axis] + grown) * inverse), shift_high = -((ray.origin[axis] - grown) * inverse);
        const float a = std::fma(box.low[axis], inverse, shift_low), b = std::fma(box.high[axis], inverse, shift_high);
        near = std::max(near, std::min(a, b)), far = std::min(far, std::max(a, b));
    }
    return {near, far};
}

bool meets(const Ray &ray, const Bounds &box, float extent, double further) {
    const Stretch stretch = stretch_in(ray, box, extent, further);
    return stretch.near <= stretch.far;
}

/// Where a plane, a corner or an edge of a cell is; or anywhere near.
vec3 place_in(const CellsUnderTest &under_test, Random &random) {
    const Bounds &cell = under_test.cells[random.below(uint(under_test.cells.size()))];
    vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
        const uint choice = random.below(4);
        p[axis] = choice == 0 ? cell.low[axis] : choice == 1 ? cell.high[axis] : random.uniform(cell.low[axis], cell.high[axis]);
    }
    return p;
}

/// From, through and along planes, edges and corners; some end where they enter a cell, to the bit; some come from so far that their pad is larger
/// than all cells together.
std::vector<Ray> rays_for(const CellsUnderTest &under_test) {
    Random random(4);
    std::vector<Ray> rays;
    for (uint i = 0; i < 20'000; ++i) {
        const vec3 through = place_in(under_test, random);
        vec3 direction = random.below(3) == 0 ? place_in(under_test, random) - through : random.direction();
        for (int axis = 0; axis < 3; ++axis)
            if (random.below(4) == 0) direction[axis] = random.below(2) ? 0.0f : -0.0f;
        if (direction == vec3(0)) direction = {0, 0, random.below(2) ? 1.0f : -1.0f};
        const float back = random.below(3) == 0 ? 0.0f : random.below(20) == 0 ? std::exp2(random.uniform(4, 24)) : random.uniform(0, 3);
        Ray ray = make_ray(through - back * direction, direction);
        const Bounds &cell = under_test.cells[random.below(uint(under_test.cells.size()))];
        if (random.below(3) == 0) ray.t_max = random.below(2) ? back : random.uniform(0, 4);
        if (random.below(3) == 0 && meets(ray, cell, extent_of(under_test.whole), 0))
            ray.t_max = stretch_in(ray, cell, extent_of(under_test.whole), 0).near;
        rays.push_back(ray);
    }
    return rays;
}

std::vector<Visits> walk(const Structure &structure, const CellsUnderTest &under_test, const std::vector<Ray> &rays) {
    Probe probe(
        std::string("#include \"kernels/accelerators/") + structure.file + R"(_walk.cl"
        typedef struct { uint count; uint cells[1024]; } Visits;
        kernel void probe(const global Ray *rays, const global uint *words, const global float *extent, global Visits *visits) {
            const uint i = get_global_id(0);
            const ray_x8 ray = prepare(rays[i], *extent);
            CellWalk walk;
            cell_walk_begin(&walk, (const global CellSpans *)words, &ray);
            uint count = 0u;
            for (uint cell = cell_walk_next(&walk, &ray); cell != NO_ITEMS; cell = cell_walk_next(&walk, &ray)) {
                if (count < 1024u) visits[i].cells[count] = cell;
                ++count;
            }
            visits[i].count = count;
        })",
        {{"generated/time.cl", "#include \"kernels/core/no_time.cl\"\n"}, {"generated/work.cl", "#include \"kernels/accelerators/no_work.cl\"\n"}});
    return probe.run<Visits>(rays, under_test.words, extent_of(under_test.whole));
}

class CellWalks : public testing::TestWithParam<Structure> {};

TEST_P(CellWalks, ComeToAllCellsOfTheRayOnce) {
    const Structure &structure = GetParam();
    const CellsUnderTest under_test = structure.make();
    const std::vector<Ray> rays = rays_for(under_test);
    const std::vector<Visits> visits = walk(structure, under_test, rays);
    const float extent = extent_of(under_test.whole);
    std::size_t missed = 0, twice = 0, beyond = 0, cells = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_LE(visits[i].count, most_visits);
        const std::set<uint> come_to(visits[i].cells, visits[i].cells + visits[i].count);
        twice += come_to.size() != visits[i].count;
        cells += come_to.size();
        for (uint cell = 0; cell < under_test.cells.size(); ++cell) {
            const bool visited = come_to.contains(cell);
            missed += !visited && meets(rays[i], under_test.cells[cell], extent, 0);
            beyond += visited && !meets(rays[i], under_test.cells[cell], extent, structure.reach);
        }
    }
    EXPECT_EQ(missed, 0u);
    EXPECT_EQ(twice, 0u);
    EXPECT_EQ(beyond, 0u) << "of " << cells;
    EXPECT_GT(cells, 4 * rays.size());
}

/// The octree's reach is twice the pad and five units, of which a pad here has at least 4; the rounding of an end is at most two of them more.
INSTANTIATE_TEST_SUITE_P(Accelerators, CellWalks,
                         testing::Values(Structure{"uniform_grid", "uniform_grid", uniform_grid, 0},
                                         Structure{"fine_grid", "uniform_grid", fine_grid, 0}, Structure{"octree", "octree", octree, 3},
                                         Structure{"kd_tree", "kd_tree", kd_tree, 0}),
                         [](const auto &info) { return std::string(info.param.name); });

}  // namespace
}  // namespace brandung
