/// kernels/samplers/stratified.cl and blue_noise.cl: whose samples share out boxes.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/kernels/samplers/positions.h"

namespace brandung {
namespace {

/// Among 2^columns by 2^rows boxes, how many have a point.
std::size_t boxes_with_points(const std::vector<vec2> &points, uint columns, uint rows) {
    std::set<uint> boxes;
    for (const vec2 &p : points) boxes.insert(uint(std::ldexp(p.x, int(columns))) | uint(std::ldexp(p.y, int(rows))) << 16);
    return boxes.size();
}

/// The first n samples of a half, of each pixel.
std::vector<vec2> first_samples(const std::string &sampler, const std::vector<uint> &of_pixels, uint half, uint n, uint use) {
    std::vector<uint> pixels, samples;
    for (const uint pixel : of_pixels)
        for (uint i = 0; i < n; ++i) pixels.push_back(pixel), samples.push_back(2 * i + half);
    return positions(sampler, pixels, samples, 9, use, 2 * n);
}

std::vector<uint> square_of_pixels(uint left, uint top, uint width) {
    std::vector<uint> pixels = some_pixels(width);
    for (uint &pixel : pixels) pixel += left | top << 16;
    return pixels;
}

TEST(Stratified, EveryBoxHasOneSampleOfEachHalf) {
    for (const uint use : {0u, 1u, 77u})
        for (const uint half : {0u, 1u})
            for (uint k = 0; k <= 8; ++k)
                EXPECT_EQ(boxes_with_points(first_samples("stratified", {123u | 45u << 16}, half, 1u << k, use), k / 2, k - k / 2), 1u << k)
                    << "use " << use << ", half " << half << ", 2^" << k;
}

TEST(Stratified, OtherPixelsAndUsesShuffleInAnotherWay) {
    const auto order = [](uint pixel, uint use) {
        std::vector<uint> cells;
        for (const vec2 &p : first_samples("stratified", {pixel}, 0, 64, use)) cells.push_back(uint(p.x * 8) + 8 * uint(p.y * 8));
        return cells;
    };
    std::set<std::vector<uint>> orders;
    for (uint pixel = 0; pixel < 16; ++pixel)
        for (uint use = 0; use < 16; ++use) orders.insert(order(pixel, use));
    EXPECT_EQ(orders.size(), 256u);
}

/// A mean of n = 2^k samples, one in each of 2^columns columns of n / 2^columns boxes.
TEST(Stratified, MeansHaveTheVarianceOfOneSampleInEachColumn) {
    constexpr uint n = 16, width = 64;
    double square = 0, mean = 0;
    const std::vector<vec2> points = first_samples("stratified", some_pixels(width), 0, n, 1);
    for (std::size_t p = 0; p < points.size(); p += n) {
        double error = -0.5;
        for (uint i = 0; i < n; ++i) error += double(points[p + i].x) / n;
        square += error * error / (width * width), mean += error / (width * width);
    }
    const double variance = 1 / (12.0 * 4 * 4 * n);  // 4 columns
    EXPECT_NEAR(square, variance, 5 * std::sqrt(2.0 / (width * width)) * variance);
    EXPECT_NEAR(mean, 0, 5 * std::sqrt(variance / (width * width)));
}

TEST(BlueNoise, EveryBoxHasOneOfASquareOfPixelsSamples) {
    for (const uint use : {0u, 1u, 77u})
        for (const uint half : {0u, 1u})
            for (const uint width : {1u, 2u, 8u})
                for (const uint n : {1u, 4u}) {
                    const uint count = width * width * n, k = uint(std::log2(count));
                    const std::vector<vec2> points = first_samples("blue_noise", square_of_pixels(64, 128, width), half, n, use);
                    for (uint a = 0; a <= k; ++a)
                        EXPECT_EQ(boxes_with_points(points, a, k - a), count) << use << ' ' << half << ' ' << width << ' ' << n << ' ' << a;
                }
}

/// One sample in each of n columns of a block's n pixels: the block's mean has variance 1 / (12 n^3), where independent ones have 1 / (12 n). Blocks
/// of one use share its scrambling, so the mean is over uses.
TEST(BlueNoise, NeighboursErrorsCancelEachOther) {
    constexpr uint n = 16, uses = 1000;
    double square = 0;
    for (uint use = 1; use <= uses; ++use) {
        double error = -0.5;
        for (const vec2 &p : first_samples("blue_noise", square_of_pixels(8, 20, 4), 0, 1, use)) error += double(p.x) / n;
        square += error * error / uses;
    }
    const double variance = 1 / (12.0 * n * n * n);
    EXPECT_NEAR(square, variance, 5 * std::sqrt(2.0 / uses) * variance);
}

/// Beyond what 32 bits number, and of more samples than were said.
TEST(BlueNoise, RunsThatDoNotFitAreOtherSequences) {
    const std::vector<uint> far = {0u, 1u << 15, 1u << 31}, samples(3, 0);
    std::set<float> places;
    for (const vec2 &p : positions("blue_noise", far, samples, 9, 1, 1u << 24)) places.insert(p.x);
    for (const vec2 &p : positions("blue_noise", {0, 0, 0}, {128, 256, 1u << 20}, 9, 1, 64)) places.insert(p.x);
    EXPECT_EQ(places.size(), 6u);
}

}  // namespace
}  // namespace brandung
