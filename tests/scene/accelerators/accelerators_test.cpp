#include <gtest/gtest.h>

#include "scene/accelerators/accelerator.h"
#include "scene/error.h"

namespace brandung {
namespace {

TEST(FindAccelerator, FindsEveryKindByItsName) {
    for (const AcceleratorKind &kind : accelerator_kinds()) EXPECT_EQ(&find_accelerator(kind.name), &kind);
}

TEST(FindAccelerator, AutoIsTheFirst) {
    EXPECT_EQ(&find_accelerator("auto"), &accelerator_kinds().front());
    EXPECT_STREQ(find_accelerator("auto").name, "wide_bvh");
}

TEST(FindAccelerator, AnUnknownNameListsTheKnownOnes) {
    try {
        find_accelerator("kd_trie");
        FAIL();
    } catch (const SceneError &error) {
        EXPECT_STREQ(
            error.what(),
            "accelerator \"kd_trie\" is not known; known are: auto, wide_bvh, uniform_grid, octree, kd_tree, kd_tree_median, bounding_volumes, none");
    }
}

}  // namespace
}  // namespace brandung
