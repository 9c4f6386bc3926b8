/// kernels/samplers/stratified.cl and core/random.cl.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/support/probe.h"

namespace brandung {
namespace {

/// Positions of all samples of a pixel on a grid.
std::vector<vec2> positions(const std::vector<uint> &pixels, const std::vector<uint> &samples, uint columns, uint rows, uint seed) {
    return Probe(R"(#include "kernels/samplers/stratified.cl"
        kernel void probe(const global uint *pixels, const global uint *samples, const global uint *columns, const global uint *rows,
                          const global uint *seed, global vec2 *positions) {
            const uint i = get_global_id(0);
            positions[i] = sampler_pixel_position(pixels[i], samples[i], *columns, *rows, *seed);
        })")
        .run<vec2>(pixels, samples, columns, rows, seed);
}

TEST(Stratified, EveryCellOfThePixelsGridHasOneSample) {
    for (const auto &[columns, rows] : {std::pair{1u, 1u}, {2u, 2u}, {16u, 16u}, {7u, 3u}, {13u, 1u}, {64u, 32u}}) {
        std::vector<uint> samples(columns * rows), pixels(columns * rows, 123u | 45u << 16);
        for (uint i = 0; i < samples.size(); ++i) samples[i] = i;
        std::set<std::pair<int, int>> cells;
        for (const vec2 &p : positions(pixels, samples, columns, rows, 9)) {
            ASSERT_TRUE(p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1);
            cells.insert({int(p.x * float(columns)), int(p.y * float(rows))});
        }
        EXPECT_EQ(cells.size(), columns * rows) << columns << " x " << rows;
    }
}

/// Means of n uniform numbers have standard deviation 1 / sqrt(12 n), products of two independent centred ones 1 / (12 sqrt(n)): 5 of them, p < 1e-6.
TEST(Stratified, PixelsSamplesSeedsAndAxesAreIndependent) {
    constexpr uint n = 1 << 16;
    std::vector<uint> pixels(n), first(n, 0), second(n, 1);
    for (uint i = 0; i < n; ++i) pixels[i] = i % 256 | (i / 256) << 16;
    const std::vector<vec2> a = positions(pixels, first, 1, 1, 0), other_seed = positions(pixels, first, 1, 1, 1),
                            b = positions(pixels, second, 1, 2, 0);
    const auto correlation = [](auto left, auto right) {
        double sum = 0;
        for (uint i = 0; i < n; ++i) sum += (left(i) - 0.5) * (right(i) - 0.5);
        return sum / n;
    };
    const double bound = 5 / (12 * std::sqrt(double(n)));
    double mean = 0;
    for (const vec2 &p : a) mean += double(p.x + p.y) / (2 * n);
    EXPECT_NEAR(mean, 0.5, 5 / std::sqrt(24.0 * n));
    EXPECT_NEAR(correlation([&](uint i) { return a[i].x; }, [&](uint i) { return a[i].y; }), 0, bound);
    EXPECT_NEAR(correlation([&](uint i) { return a[i].x; }, [&](uint i) { return a[(i + 1) % n].x; }), 0, bound);
    EXPECT_NEAR(correlation([&](uint i) { return a[i].y; }, [&](uint i) { return a[(i + 256) % n].y; }), 0, bound);
    EXPECT_NEAR(correlation([&](uint i) { return a[i].x; }, [&](uint i) { return other_seed[i].x; }), 0, bound);
    EXPECT_NEAR(correlation([&](uint i) { return a[i].x; }, [&](uint i) { return b[i].x; }), 0, bound);
}

TEST(Stratified, APixelsSampleIsTheSameWhateverElseIsAskedFor) {
    const std::vector<vec2> all = positions({7, 8, 9}, {3, 3, 3}, 2, 2, 5), one = positions({8}, {3}, 2, 2, 5);
    EXPECT_EQ(all[1], one[0]);
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

}  // namespace
}  // namespace brandung
