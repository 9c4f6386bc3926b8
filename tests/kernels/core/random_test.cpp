/// kernels/core/random.cl: as the renderer asks it, its numbers are those of a random source.
#include "kernels/core/portable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/probe.h"
#include "tests/support/statistics/chi_square.h"
#include "tests/support/statistics/significance.h"
#include "tests/support/statistics/uniformity.h"

namespace brandung {
namespace {

using statistics::plausible;

/// The ways in which numbers are drawn: of neighbouring pixels, of the two children of a ray and theirs, and one after another from one pixel.
constexpr const char *ways[] = {"hash(i)", "hash(hash(i * 2u) * 2u + 1u)", "hash(hash(77u) + i)", "hash(5u ^ hash(i ^ hash(3u)))"};

constexpr uint count = 1 << 18;

/// For i from 0 on: the number, and the next that is made of it.
std::vector<vec2> pairs(const std::string &way) {
    std::vector<uint> i(count);
    for (uint k = 0; k < count; ++k) i[k] = k;
    return Probe(R"(#include "kernels/core/random.cl"
        kernel void probe(const global uint *numbers, global vec2 *pairs) {
            const uint i = numbers[get_global_id(0)];
            const uint random = )" +
                 way + R"(;
            pairs[get_global_id(0)].x = unit_interval(random);
            pairs[get_global_id(0)].y = unit_interval(hash(random + 1u));
        })")
        .run<vec2>(i);
}

double p_of_uniform(const std::vector<std::uint64_t> &counts) { return statistics::chi_square(counts, std::vector<double>(counts.size(), 1)).p; }

class RandomNumbers : public testing::TestWithParam<const char *> {};

}  // namespace

/// A number and the next, and numbers of neighbours: in 32 x 32 cells.
TEST_P(RandomNumbers, FillSquaresUniformly) {
    const std::vector<vec2> points = pairs(GetParam());
    std::vector<std::uint64_t> next(1024), neighbours(1024), rows(1024);
    const auto cell = [](float x, float y) { return std::size_t(x * 32) * 32 + std::size_t(y * 32); };
    for (uint i = 0; i + 512 < count; i += 2) {
        ++next[cell(points[i].x, points[i].y)];
        ++neighbours[cell(points[i].x, points[i + 1].x)];
        ++rows[cell(points[i].x, points[i + 512].x)];
    }
    EXPECT_TRUE(plausible({p_of_uniform(next), p_of_uniform(neighbours), p_of_uniform(rows)}));
}

/// Numbers of few things are as random as those of many: of every 256 one after another, in 16 cells, p-values are uniform.
TEST_P(RandomNumbers, AreRandomInEveryNeighbourhood) {
    const std::vector<vec2> points = pairs(GetParam());
    std::vector<double> p_values;
    for (uint begin = 0; begin < count; begin += 256) {
        std::vector<std::uint64_t> counts(16);
        for (uint i = begin; i < begin + 256; ++i) ++counts[std::size_t(points[i].x * 16)];
        p_values.push_back(p_of_uniform(counts));
    }
    EXPECT_TRUE(plausible(p_values));
    EXPECT_TRUE(plausible(statistics::uniformity_p(p_values)));
}

TEST(Random, HashMapsDifferentNumbersToDifferentOnes) {
    constexpr uint n = 1 << 20;
    std::vector<uint> x(n);
    for (uint i = 0; i < n; ++i) x[i] = i;
    std::vector<uint> y = Probe(R"(#include "kernels/core/random.cl"
        kernel void probe(const global uint *x, global uint *y) { y[get_global_id(0)] = hash(x[get_global_id(0)]); })")
                              .run<uint>(x);
    std::sort(y.begin(), y.end());
    EXPECT_EQ(std::unique(y.begin(), y.end()), y.end());
}

TEST(Random, UnitIntervalIsAtLeast0AndBelow1) {
    const std::vector<float> y = Probe(R"(#include "kernels/core/random.cl"
        kernel void probe(const global uint *x, global float *y) { y[get_global_id(0)] = unit_interval(x[get_global_id(0)]); })")
                                     .run<float>(std::vector<uint>{0, 255, 256, 0x80000000u, 0xffffffffu});
    EXPECT_EQ(y, (std::vector<float>{0, 0, 0x1p-24f, 0.5f, 1 - 0x1p-24f}));
}

INSTANTIATE_TEST_SUITE_P(Kernels, RandomNumbers, testing::ValuesIn(ways), [](const auto &info) { return "Way" + std::to_string(info.index); });

}  // namespace brandung
