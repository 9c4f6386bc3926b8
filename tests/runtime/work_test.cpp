#include "runtime/wavefront/work.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

namespace brandung {
namespace {

std::vector<uint> all(uint width, uint height, std::size_t at_once) {
    PixelOrder order({0, 0, width, height});
    std::vector<uint> pixels;
    for (auto next = order.next(at_once); !next.empty(); next = order.next(at_once)) {
        EXPECT_LE(next.size(), at_once);
        pixels.insert(pixels.end(), next.begin(), next.end());
    }
    EXPECT_TRUE(order.next(at_once).empty());
    return pixels;
}

TEST(PixelOrder, EveryPixelComesOnce) {
    for (const auto &[width, height] :
         {std::pair{1u, 1u}, {7u, 5u}, {8u, 8u}, {9u, 8u}, {8u, 9u}, {513u, 513u}, {1u, 1000u}, {1000u, 1u}, {65536u, 1u}}) {
        const std::vector<uint> pixels = all(width, height, 1000);
        EXPECT_EQ(pixels.size(), std::size_t{width} * height);
        EXPECT_EQ(std::set<uint>(pixels.begin(), pixels.end()).size(), pixels.size());
        for (const uint pixel : pixels) ASSERT_TRUE((pixel & 0xffff) < width && pixel >> 16 < height) << width << " x " << height;
    }
}

TEST(PixelOrder, TheOrderDoesNotDependOnHowManyAreTakenAtOnce) {
    const std::vector<uint> expected = all(101, 67, 1u << 20);
    for (const std::size_t at_once : {std::size_t{1}, std::size_t{63}, std::size_t{64}, std::size_t{1000}})
        EXPECT_EQ(all(101, 67, at_once), expected);
}

TEST(PixelOrder, SixteenNeighboursInTheListLieInASquareOfFour) {
    const std::vector<uint> pixels = all(64, 64, 4096);
    for (std::size_t i = 0; i < pixels.size(); i += 16) {
        uint low_x = 64, high_x = 0, low_y = 64, high_y = 0;
        for (std::size_t j = i; j < i + 16; ++j) {
            low_x = std::min(low_x, pixels[j] & 0xffff), high_x = std::max(high_x, pixels[j] & 0xffff);
            low_y = std::min(low_y, pixels[j] >> 16), high_y = std::max(high_y, pixels[j] >> 16);
        }
        ASSERT_TRUE(high_x - low_x == 3 && high_y - low_y == 3) << i;
    }
}

TEST(PixelOrder, OfAWindowIsThatOfAPictureOfItsSizeMovedThere) {
    PixelOrder order({1000, 60000, 1013, 60009});
    const std::vector<uint> moved = order.next(1000), at_origin = all(13, 9, 1000);
    ASSERT_EQ(moved.size(), at_origin.size());
    for (std::size_t i = 0; i < moved.size(); ++i) ASSERT_EQ(moved[i], at_origin[i] + (1000u | 60000u << 16));
}

}  // namespace
}  // namespace brandung
