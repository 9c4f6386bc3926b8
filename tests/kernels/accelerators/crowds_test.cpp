/// Hits with others at nearly the same place, which all traversals tell alike.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/kernels/accelerators/hard_scenes.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_scene.h"

namespace brandung {
namespace {

/// Two large triangles at one place, which are met at the root of a hierarchy, about many small ones.
Scene panes() {
    Scene scene = empty_scene();
    for (uint copy = 0; copy < 2; ++copy) add_triangle(scene, 0, vec3(-9, -9, 0.5f), vec3(9, -9, 0.5f), vec3(0, 9, 0.5f));
    add_soup(scene, 0, {.counts = {{"triangle", 400}}});
    return scene;
}

/// Of glass.
void expect_crowds_alike(Scene scene) {
    scene.materials.at(0).record = glass(1.5f);
    const std::vector<Ray> rays = make_rays(scene, vec3(0));
    TracedScene all(scene, "none");
    all.closest_hits(rays);
    const std::vector<std::uint8_t> expected = all.crowded();
    const auto crowds = std::ranges::count(expected, 1);
    ASSERT_GT(crowds, 1000);
    ASSERT_LT(crowds, std::ssize(expected) - 1000);
    TracedScene traced(scene, accelerator_kinds().front().name);
    for (const Traversal &traversal : traced.traversals()) {
        traced.closest_hits(traversal, rays);
        std::size_t different = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) different += traced.crowded()[i] != expected[i];
        EXPECT_EQ(different, 0u) << traversal.name << ", of " << rays.size();
    }
}

TEST(Crowds, AreToldAlikeByAllTraversals) { expect_crowds_alike(duplicates()); }

TEST(Crowds, AreToldAlikeWhereTheyAreAtTheRoot) {
    Scene scene = panes();
    EXPECT_TRUE(compile(scene).blocks_at_root);
    expect_crowds_alike(std::move(scene));
}

}  // namespace
}  // namespace brandung
