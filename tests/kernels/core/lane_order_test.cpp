/// kernels/core/lane_order.cl, and what stands for its instructions on processors that lack them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <functional>

#include "tests/support/probe.h"

namespace brandung {
namespace {

using Lanes = std::array<int, 8>;

constexpr uint subsets = 256;

class LaneOrder : public testing::TestWithParam<const char *> {
protected:
    /// `body` reads numbers `v` and `n`, which is the item's number, and writes to `to`, of 8.
    std::vector<Lanes> results(const std::string &body, const std::vector<Lanes> &lanes) {
        return Probe(GetParam() + std::string(R"(#include "kernels/core/lane_order.cl"
            kernel void probe(const global int8 *lanes, global int8 *results) {
                const uint n = get_global_id(0);
                const int8 v = lanes[n];
                uint to[8] = {0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u};
                )") + body +
                     "results[n] = as_int8(vload8(0, to)); }")
            .run<Lanes>(lanes);
    }
};

/// A network that sorts all zeros and ones sorts all (Knuth, The Art of Computer Programming 3, 5.3.4, theorem Z).
TEST_P(LaneOrder, SortsAllZerosAndOnes) {
    std::vector<Lanes> lanes(subsets);
    for (uint n = 0; n < subsets; ++n)
        for (uint lane = 0; lane < 8; ++lane) lanes[n][lane] = int(n >> lane & 1) - 1;
    const std::vector<Lanes> found = results("vstore8(as_uint8(sorted(v)), 0, to);", lanes);
    for (uint n = 0; n < subsets; ++n) {
        std::ranges::sort(lanes[n], std::greater());
        ASSERT_EQ(found[n], lanes[n]) << n;
    }
}

/// The same of every subset.
TEST_P(LaneOrder, SortsThoseOfEverySubset) {
    std::vector<Lanes> lanes(subsets * subsets);
    for (uint n = 0; n < lanes.size(); ++n)
        for (uint lane = 0; lane < 8; ++lane) lanes[n][lane] = n >> lane & 1 ? int(n / subsets >> lane & 1) : -1;
    const std::vector<Lanes> found = results("vstore8(as_uint8(sorted(v, n & 255u)), 0, to);", lanes);
    for (uint n = 0; n < lanes.size(); ++n) {
        std::ranges::sort(lanes[n], std::greater());
        ASSERT_EQ(found[n], lanes[n]) << n;
    }
}

TEST_P(LaneOrder, PicksByTheLastThreeBits) {
    std::vector<Lanes> lanes(subsets);
    for (uint n = 0; n < subsets; ++n)
        for (uint lane = 0; lane < 8; ++lane) lanes[n][lane] = int(n * (2 * lane + 1) * 37);
    const std::vector<Lanes> found = results("vstore8(picked((uint8)(10u, 11u, 12u, 13u, 14u, 15u, 16u, 17u), as_uint8(v)), 0, to);", lanes);
    for (uint n = 0; n < subsets; ++n)
        for (uint lane = 0; lane < 8; ++lane) ASSERT_EQ(found[n][lane], 10 + (lanes[n][lane] & 7)) << n;
}

TEST_P(LaneOrder, StoresThoseOfEverySubset) {
    const std::vector<Lanes> lanes(subsets, Lanes{20, 21, 22, 23, 24, 25, 26, 27});
    const std::vector<Lanes> found = results("store_picked(as_uint8(v), n, to);", lanes);
    for (uint n = 0; n < subsets; ++n) {
        uint place = 0;
        for (uint lane = 0; lane < 8; ++lane) {
            if (n >> lane & 1) {
                ASSERT_EQ(found[n][place++], lanes[n][lane]) << n;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kernels, LaneOrder, testing::Values("", "#undef __AVX2__\n#undef __AVX512VL__\n"),
                         [](const auto &info) { return info.index == 0 ? "OfThisMachine" : "Portable"; });

}  // namespace
}  // namespace brandung
