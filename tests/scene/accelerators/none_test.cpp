#include <gtest/gtest.h>

#include "tests/support/accelerators.h"

namespace brandung {
namespace {

/// A letter per reference: its kind.
BuiltAccelerator build(const std::string &kinds) {
    std::vector<Reference> references;
    for (const char letter : kinds) {
        references.push_back({{vec3(0), vec3(1)}, uint(letter - 'a')});
    }
    return build_accelerator("none", references);
}

std::vector<std::vector<uint>> blocks_of(const BuiltAccelerator &built, uint kind) {
    std::vector<std::vector<uint>> blocks;
    for (const PrimitiveBlock &block : built.blocks[kind]) blocks.emplace_back(block.references.begin(), block.references.begin() + block.count);
    return blocks;
}

using Blocks = std::vector<std::vector<uint>>;

TEST(None, NothingMakesNoBlocks) {
    for (const auto &blocks : build("").blocks) EXPECT_TRUE(blocks.empty());
}

TEST(None, ReferencesAreInSceneOrderEightPerBlock) {
    EXPECT_EQ(blocks_of(build("aaaaaaaaaaaaaaaaa"), 0), (Blocks{{0, 1, 2, 3, 4, 5, 6, 7}, {8, 9, 10, 11, 12, 13, 14, 15}, {16}}));
}

TEST(None, EveryKindFillsBlocksOfItsOwn) {
    const BuiltAccelerator built = build("aabbbabh");
    EXPECT_EQ(blocks_of(built, 0), (Blocks{{0, 1, 5}}));
    EXPECT_EQ(blocks_of(built, 1), (Blocks{{2, 3, 4, 6}}));
    EXPECT_EQ(blocks_of(built, 7), (Blocks{{7}}));
}

TEST(None, ThereAreNoNodes) {
    const BuiltAccelerator built = build("ab");
    EXPECT_EQ(built.node_count, 0u);
    EXPECT_TRUE(built.nodes.empty());
}

}  // namespace
}  // namespace brandung
