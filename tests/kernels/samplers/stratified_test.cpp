/// kernels/samplers/stratified.cl and core/random.cl.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "kernels/core/params.h"
#include "tests/support/probe.h"

namespace brandung {
namespace {

BatchParams grids(std::pair<uint, uint> even, std::pair<uint, uint> odd, uint seed) {
    return {.pixels = 0,
            .first_sample = 0,
            .samples = 0,
            .spp = even.first * even.second + odd.first * odd.second,
            .columns = {even.first, odd.first},
            .rows = {even.second, odd.second},
            .seed = seed,
            .position = PIXEL_CENTER};
}

std::vector<vec2> positions(const std::vector<uint> &pixels, const std::vector<uint> &samples, const BatchParams &batch) {
    return Probe(R"(#include "kernels/samplers/stratified.cl"
        kernel void probe(const global uint *pixels, const global uint *samples, const global BatchParams *batch, global vec2 *positions) {
            const uint i = get_global_id(0);
            positions[i] = sampler_pixel_position(pixels[i], samples[i], *batch);
        })")
        .run<vec2>(pixels, samples, batch);
}

/// Whether x lies in the cell, whose bounds are floats.
bool is_in_cell(float x, uint place, uint count) { return x >= float(place) / float(count) && x < float(place + 1) / float(count); }

/// Numbers that unit_interval gives: its ends, those beside them, and others.
std::vector<uint> random_words() {
    std::vector<uint> words = {0, 255, 256, 0x7fffffffu, 0x80000000u, 0xfffffe00u, 0xfffffeffu, 0xffffff00u, 0xffffffffu};
    for (uint i = 0; i < 64; ++i) words.push_back(i * 0x9e3779b9u);
    return words;
}

TEST(Stratified, WhateverTheRandomNumberAPlaceIsInItsOwnCellAndBelow1) {
    const std::vector<uint> words = random_words();
    std::vector<uint> places, counts, random;
    for (const uint count : {1u, 2u, 3u, 4u, 7u, 10u, 49u, 64u, 1000u, 4095u, 4096u, 1u << 20, (1u << 23) - 1, 1u << 23})
        for (const uint place : {0u, 1u, 2u, 3u, count / 3, count / 2, count - 2, count - 1})
            for (const uint word : words)
                if (place < count) places.push_back(place), counts.push_back(count), random.push_back(word);
    const std::vector<float> x = Probe(R"(#include "kernels/samplers/stratified.cl"
        kernel void probe(const global uint *places, const global uint *counts, const global uint *random, global float *x) {
            const uint i = get_global_id(0);
            x[i] = stratum(places[i], max(counts[i], 1u), random[i]);
        })")
                                     .run<float>(places, counts, random);
    for (std::size_t i = 0; i < x.size(); ++i) {
        ASSERT_LT(x[i], 1) << places[i] << " of " << counts[i] << ", " << std::hex << random[i];
        ASSERT_TRUE(is_in_cell(x[i], places[i], counts[i])) << x[i] << ": " << places[i] << " of " << counts[i] << ", " << std::hex << random[i];
    }
}

TEST(Stratified, EveryCellOfEachHalfsGridHasOneSample) {
    for (const auto &[columns, rows] : {std::pair{1u, 1u}, {2u, 2u}, {16u, 16u}, {7u, 3u}, {13u, 1u}, {64u, 32u}}) {
        // The odd samples have a grid of their own, one column smaller.
        const std::pair<uint, uint> grid[2] = {{columns, rows}, {std::max(columns - 1, 1u), rows}};
        for (const uint half : {0u, 1u}) {
            const auto [own_columns, own_rows] = grid[half];
            std::vector<uint> samples(own_columns * own_rows), pixels(samples.size(), 123u | 45u << 16);
            for (uint i = 0; i < samples.size(); ++i) samples[i] = 2 * i + half;
            const std::vector<vec2> points = positions(pixels, samples, grids(grid[0], grid[1], 9));
            for (uint i = 0; i < samples.size(); ++i) {
                ASSERT_TRUE(is_in_cell(points[i].x, i % own_columns, own_columns)) << points[i].x;
                ASSERT_TRUE(is_in_cell(points[i].y, i / own_columns, own_rows)) << points[i].y;
            }
        }
    }
}

/// Each half's mean of a linear ramp is 1/2 in expectation. One of n samples in C columns has variance 1 / (12 C²) about its column's centre, so
/// the mean of a half has 1 / (12 n C²) and that of m pixels' means a standard deviation of 1 / (C sqrt(12 n m)): 5 of them, p < 1e-6. The mean
/// square is 1 / (12 n C²) within 5 sqrt(2 / m) of itself: sqrt(2 / m) is its relative deviation for normal means, and less for uniform ones.
TEST(Stratified, EachHalfAloneIsAnUnbiasedStratifiedEstimate) {
    constexpr uint pixel_count = 4096;
    const std::pair<uint, uint> grids_of_halves[] = {{1, 1}, {2, 1}, {3, 1}, {4, 2}, {4, 4}, {8, 4}};
    for (const auto &even : grids_of_halves)
        for (const auto &odd : {even, std::pair{2u, 1u}})
            for (const uint half : {0u, 1u}) {
                const auto [columns, rows] = half == 0 ? even : odd;
                const uint n = columns * rows;
                std::vector<uint> pixels, samples;
                for (uint p = 0; p < pixel_count; ++p)
                    for (uint i = 0; i < n; ++i) pixels.push_back(p % 64 | (p / 64) << 16), samples.push_back(2 * i + half);
                const std::vector<vec2> points = positions(pixels, samples, grids(even, odd, 3));
                double sum = 0, squares = 0;
                for (uint p = 0; p < pixel_count; ++p) {
                    double mean = 0;
                    for (uint i = 0; i < n; ++i) mean += double(points[p * n + i].x) / n;
                    sum += mean - 0.5, squares += (mean - 0.5) * (mean - 0.5);
                }
                const double variance = 1 / (12.0 * n * columns * columns);
                EXPECT_NEAR(sum / pixel_count, 0, 5 * std::sqrt(variance / pixel_count)) << columns << " x " << rows << ", half " << half;
                EXPECT_NEAR(squares / pixel_count, variance, 5 * std::sqrt(2.0 / pixel_count) * variance) << columns << " x " << rows;
            }
}

/// Means of n uniform numbers have standard deviation 1 / sqrt(12 n), products of two independent centred ones 1 / (12 sqrt(n)): 5 of them, p < 1e-6.
TEST(Stratified, PixelsSamplesHalvesSeedsAndAxesAreIndependent) {
    constexpr uint n = 1 << 16;
    std::vector<uint> pixels(n), first(n, 0), second(n, 1), third(n, 2);
    for (uint i = 0; i < n; ++i) pixels[i] = i % 256 | (i / 256) << 16;
    const BatchParams one = grids({1, 1}, {1, 1}, 0), two_rows = grids({1, 2}, {1, 1}, 0);
    const std::vector<vec2> a = positions(pixels, first, one), other_seed = positions(pixels, first, grids({1, 1}, {1, 1}, 1)),
                            other_half = positions(pixels, second, one), b = positions(pixels, third, two_rows);
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
    EXPECT_NEAR(correlation([&](uint i) { return a[i].x; }, [&](uint i) { return other_half[i].x; }), 0, bound);
    EXPECT_NEAR(correlation([&](uint i) { return a[i].y; }, [&](uint i) { return other_half[i].y; }), 0, bound);
    EXPECT_NEAR(correlation([&](uint i) { return a[i].x; }, [&](uint i) { return b[i].x; }), 0, bound);
}

TEST(Stratified, APixelsSampleIsTheSameWhateverElseIsAskedFor) {
    const BatchParams batch = grids({2, 2}, {2, 2}, 5);
    const std::vector<vec2> all = positions({7, 8, 9}, {3, 3, 3}, batch), one = positions({8}, {3}, batch);
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
