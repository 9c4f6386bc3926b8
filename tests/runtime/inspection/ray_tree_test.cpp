#include "runtime/inspection/ray_tree.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brandung {
namespace {

/// A contribution that is not finite is refused by the sums; nearest is to even, magnitudes end at 2^17.
TEST(FixedPoint, IsWhatIsAccumulated) {
    EXPECT_EQ(fixed_point({1, -0.5f, 0x1p-33f}), (FixedPoint{std::int64_t{1} << 32, -(std::int64_t{1} << 31), 0}));
    EXPECT_EQ(fixed_point({0x1.8p-32f, 1e9f, -1e9f}), (FixedPoint{2, std::int64_t{1} << 49, -(std::int64_t{1} << 49)}));
    EXPECT_EQ(fixed_point({1, NAN, 1}), FixedPoint{});
}

}  // namespace
}  // namespace brandung
