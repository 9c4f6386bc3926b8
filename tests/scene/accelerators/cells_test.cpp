/// Structures that divide space: what lies in a cell is in its list, and each primitive is in one block.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <functional>
#include <ostream>
#include <random>

#include "tests/scene/accelerators/decoded_cells.h"
#include "tests/support/accelerators.h"

namespace brandung {
namespace {

using References = std::vector<Reference>;

struct Structure {
    const char *name;
    std::vector<DecodedCell> (*decode)(const BuiltAccelerator &built);
    double reach;  ///< of a cell beyond its bounds, as part of the whole: within it lists may have more
};
void PrintTo(const Structure &structure, std::ostream *out) { *out << structure.name; }

/// The octree rounds boxes outward to units, 2^-23 of its side.
const std::vector<Structure> structures = {{"uniform_grid", decode_uniform_grid, 0}, {"octree", decode_octree, 0x1p-22}};

References random_boxes(uint count, float size, vec3 scale = vec3(1), vec3 shift = vec3(0)) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0, 1);
    References references(count);
    for (Reference &reference : references) {
        const vec3 low(unit(random), unit(random), unit(random)), extent(unit(random), unit(random), unit(random));
        reference = {{low * scale + shift, (low + size * extent) * scale + shift}, uint(random() % 3)};
    }
    return references;
}

/// Sides in planes where cells are likely to end.
References boxes_on_a_lattice() {
    References references;
    for (uint i = 0; i < 64; ++i) {
        const vec3 low = 0.25f * vec3(i % 4, i / 4 % 4, i / 16);
        references.push_back({{low, low + vec3(0.25f, 0.25f, i % 3 == 0 ? 0.0f : 0.25f)}, 0});
    }
    return references;
}

struct Case {
    const char *name;
    References references;
};

std::vector<Case> cases() {
    return {
        {"nothing", {}},
        {"one", random_boxes(1, 1)},
        {"one_point", {{{vec3(2), vec3(2)}, 0}}},
        {"many", random_boxes(1000, 0.1f)},
        {"large_and_small",
         [] {
             References references = random_boxes(300, 0.02f);
             for (uint i = 0; i < 20; ++i) references[i * 7].bounds.high = references[i * 7].bounds.low + vec3(0.7f, 0.1f, 0.9f);
             return references;
         }()},
        {"lattice", boxes_on_a_lattice()},
        {"flat", random_boxes(300, 0.1f, {1, 0, 1})},
        {"line", random_boxes(300, 0.1f, {0, 1, 0})},
        {"points", random_boxes(300, 0)},
        {"coincident", References(300, {{vec3(1, 2, 3), vec3(2, 3, 4)}, 1})},
        {"coincident_points", References(300, {{vec3(1), vec3(1)}, 1})},
        {"far_away", random_boxes(300, 0.1f, vec3(1), {8192, -8192, 0})},
        {"huge", random_boxes(300, 0.1f, vec3(1e15f))},
        {"tiny", random_boxes(300, 0.1f, vec3(1e-37f))},
        {"clumped",
         [] {
             References references = random_boxes(300, 0.1f, vec3(1e-4f));
             references.push_back({{vec3(9), vec3(10)}, 0});
             return references;
         }()},
    };
}

void PrintTo(const Case &given, std::ostream *out) { *out << given.name; }

using OfCells = testing::TestWithParam<std::tuple<Structure, Case>>;

TEST_P(OfCells, EveryReferenceIsInEveryCellThatItsBoxHasAPartIn) {
    const auto &[structure, given] = GetParam();
    const BuiltAccelerator built = build_accelerator(structure.name, given.references);
    const std::vector<DecodedCell> cells = structure.decode(built);
    ASSERT_FALSE(cells.empty());
    std::vector<uint> listed(given.references.size(), 0);
    glm::dvec3 low(cells[0].low), high(cells[0].high);
    for (const DecodedCell &cell : cells) low = glm::min(low, cell.low), high = glm::max(high, cell.high);
    const glm::dvec3 reach = structure.reach * (high - low), rounding = 0.01 * reach;  // of quotients; outward there are whole units
    for (const DecodedCell &cell : cells) {
        for (uint i = 0; i < given.references.size(); ++i) {
            const glm::dvec3 from(given.references[i].bounds.low), to(given.references[i].bounds.high);
            const bool is_listed = cell.references.contains(i);
            listed[i] += is_listed;
            EXPECT_TRUE(is_listed || !(glm::all(glm::lessThan(from, cell.high - rounding)) && glm::all(glm::greaterThan(to, cell.low + rounding))))
                << i;
            EXPECT_TRUE(!is_listed ||
                        (glm::all(glm::lessThanEqual(from, cell.high + reach)) && glm::all(glm::greaterThanEqual(to, cell.low - reach))))
                << i;
        }
    }
    for (uint i = 0; i < given.references.size(); ++i) {
        EXPECT_GT(listed[i], 0u) << i << " is in no cell";
        EXPECT_TRUE(glm::all(glm::greaterThanEqual(glm::dvec3(given.references[i].bounds.low), low)) &&
                    glm::all(glm::lessThanEqual(glm::dvec3(given.references[i].bounds.high), high)))
            << i << " is not within the whole";
    }
}

/// Of volumes too.
using OfBlocks = testing::TestWithParam<std::tuple<const char *, Case>>;

TEST_P(OfBlocks, EveryReferenceIsInOneBlockOfItsKind) {
    const auto &[name, given] = GetParam();
    const BuiltAccelerator built = build_accelerator(name, given.references);
    std::vector<uint> placed(given.references.size(), 0);
    for (uint kind = 0; kind < MAX_PRIMITIVE_KINDS; ++kind)
        for (const PrimitiveBlock &block : built.blocks[kind])
            for (uint lane = 0; lane < block.count; ++lane) {
                ++placed.at(block.references[lane]);
                EXPECT_EQ(given.references[block.references[lane]].kind, kind);
            }
    EXPECT_EQ(placed, std::vector<uint>(given.references.size(), 1));
}

INSTANTIATE_TEST_SUITE_P(Accelerators, OfCells, testing::Combine(testing::ValuesIn(structures), testing::ValuesIn(cases())),
                         [](const auto &info) { return std::string(std::get<0>(info.param).name) + "_" + std::get<1>(info.param).name; });

INSTANTIATE_TEST_SUITE_P(Accelerators, OfBlocks,
                         testing::Combine(testing::Values("uniform_grid", "octree", "bounding_volumes"), testing::ValuesIn(cases())),
                         [](const auto &info) { return std::string(std::get<0>(info.param)) + "_" + std::get<1>(info.param).name; });

class ManyReferences : public testing::TestWithParam<const char *> {};

TEST_P(ManyReferences, AreBuiltTheSameByAnyNumberOfThreads) {
    const References references = random_boxes(30'000, 0.02f);
    const BuiltAccelerator expected = build_accelerator(GetParam(), references);
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    const BuiltAccelerator built = build_accelerator(GetParam(), references);
    EXPECT_EQ(built.nodes, expected.nodes);
    for (uint kind = 0; kind < MAX_PRIMITIVE_KINDS; ++kind) {
        ASSERT_EQ(built.blocks[kind].size(), expected.blocks[kind].size());
        for (std::size_t b = 0; b < built.blocks[kind].size(); ++b) EXPECT_EQ(built.blocks[kind][b].references, expected.blocks[kind][b].references);
    }
}

INSTANTIATE_TEST_SUITE_P(Accelerators, ManyReferences, testing::Values("uniform_grid", "octree", "bounding_volumes"),
                         [](const auto &info) { return std::string(info.param); });

class CellStructures : public testing::TestWithParam<Structure> {};

/// Dividing what fills every cell would only list it again and again.
TEST_P(CellStructures, AMillionCoincidentObjectsAreListedOnce) {
    const BuiltAccelerator built = build_accelerator(GetParam().name, References(1'000'000, {{vec3(1, 2, 3), vec3(2, 3, 4)}, 0}));
    EXPECT_EQ(built.blocks[0].size(), 125'000u);
    EXPECT_LT(built.nodes.size(), 125'000u * 5u + 4096u);  // five bytes for an item
}

/// Objects in a clump that is a ten-thousandth as wide as the scene share one cell of it, unless the structure looks closer there.
TEST(CellStructures, TheOctreeDividesAClumpAndTheGridCannot) {
    References references = random_boxes(4000, 0.02f, vec3(1e-3f));
    references.push_back({{vec3(9), vec3(10)}, 0});
    const auto fullest = [&](const char *name, auto decode) {
        std::size_t most = 0;
        for (const DecodedCell &cell : decode(build_accelerator(name, references))) most = std::max(most, cell.references.size());
        return most;
    };
    EXPECT_EQ(fullest("uniform_grid", decode_uniform_grid), 4000u);
    EXPECT_LT(fullest("octree", decode_octree), 64u);  // it divides from some 2 * 8 / (1 - 1/4) on
}

INSTANTIATE_TEST_SUITE_P(Accelerators, CellStructures, testing::ValuesIn(structures), [](const auto &info) { return info.param.name; });

}  // namespace
}  // namespace brandung
