#include "scene/primitives/point_tree.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace brandung {
namespace {

/// Against a list, while points are taken out: numbers in random boxes, on a coarse grid so that many points share coordinates and places.
TEST(PointTree, FindsWhatAListFinds) {
    std::mt19937 random(1);
    for (const uint count : {0u, 1u, 2u, 3u, 50u, 1000u}) {
        std::vector<PointTree::Point> points;
        for (uint i = 0; i < count; ++i) points.push_back({{random() % 20, random() % 20}, 2 * i});  // every other number is nobody's
        PointTree tree(points, 2 * count + 2);
        std::set<uint> gone;
        for (uint round = 0; round < 200; ++round) {
            const glm::dvec2 low(random() % 20, random() % 20), high = low + glm::dvec2(random() % 8, random() % 8);
            const auto inside = [&](glm::dvec2 p) { return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y; };
            std::set<uint> found, expected;
            tree.any([&](glm::dvec2 least, glm::dvec2 most) { return least.x <= high.x && most.x >= low.x && least.y <= high.y && most.y >= low.y; },
                     [&](uint number) {
                         if (inside(points[number / 2].place)) found.insert(number);
                         return false;
                     });
            for (const PointTree::Point &point : points)
                if (inside(point.place) && !gone.contains(point.number)) expected.insert(point.number);
            ASSERT_EQ(found, expected) << count << " points, round " << round;
            const uint out = random() % (2 * count + 2);
            tree.remove(out), gone.insert(out);
        }
    }
}

TEST(PointTree, EndsAtTheFirstPointThatHolds) {
    PointTree tree({{{0, 0}, 0}, {{1, 1}, 1}, {{2, 2}, 2}}, 3);
    const auto everywhere = [](glm::dvec2, glm::dvec2) { return true; };
    uint asked = 0;
    EXPECT_TRUE(tree.any(everywhere, [&](uint) { return ++asked == 2; }));
    EXPECT_EQ(asked, 2u);
    for (const uint number : {0u, 1u, 2u}) tree.remove(number);
    EXPECT_FALSE(tree.any(everywhere, [](uint) { return true; }));
}

}  // namespace
}  // namespace brandung
