/// What all samplers of scene/samplers promise.
#include <gtest/gtest.h>

#include <cmath>

#include "scene/samplers/sampler.h"
#include "tests/kernels/samplers/positions.h"

namespace brandung {
namespace {

std::vector<std::string> sampler_names() {
    std::vector<std::string> names;
    for (const SamplerKind &kind : sampler_kinds()) names.emplace_back(kind.name);
    return names;
}

class SamplerOf : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Kernels, SamplerOf, testing::ValuesIn(sampler_names()), [](const auto &info) { return info.param; });

TEST_P(SamplerOf, PositionsAreAtLeast0AndBelow1) {
    constexpr uint n = 1 << 16;
    std::vector<uint> samples(n), pixels(n, 5u | 7u << 16);
    for (uint i = 0; i < n; ++i) samples[i] = i;
    for (const vec2 &p : positions(GetParam(), pixels, samples, 1)) ASSERT_TRUE(p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1) << p.x << ' ' << p.y;
}

/// Counts of 2^16 pixels' samples of one number in 16 x 16 cells: chi-square with 255 degrees of freedom lies above 377 with p < 1e-6.
TEST_P(SamplerOf, APixelsSampleOfAnyNumberIsUniform) {
    for (const uint sample : {0u, 1u, 2u, 3u, 4u, 7u, 30u, 1001u}) {
        const std::vector<uint> pixels = some_pixels(256), samples(pixels.size(), sample);
        std::vector<double> counts(256);
        for (const vec2 &p : positions(GetParam(), pixels, samples, 11)) ++counts[uint(p.x * 16) + 16 * uint(p.y * 16)];
        double chi_square = 0;
        for (const double count : counts) chi_square += (count - 256) * (count - 256) / 256;
        EXPECT_LT(chi_square, 377) << "sample " << sample;
    }
}

/// Products of two independent centred numbers have standard deviation 1 / (12 sqrt(n)): 5 of them, p < 1e-6.
TEST_P(SamplerOf, PixelsHalvesSeedsAndAxesAreIndependent) {
    constexpr uint n = 1 << 16;
    const std::vector<uint> pixels = some_pixels(256), first(n, 0), second(n, 1), third(n, 3);
    const std::vector<vec2> a = positions(GetParam(), pixels, first, 0), other_seed = positions(GetParam(), pixels, first, 1),
                            other_half = positions(GetParam(), pixels, second, 0), later = positions(GetParam(), pixels, third, 0);
    const auto correlation = [](auto left, auto right) {
        double sum = 0;
        for (uint i = 0; i < n; ++i) sum += (left(i) - 0.5) * (right(i) - 0.5);
        return sum / n;
    };
    const double bound = 5 / (12 * std::sqrt(double(n)));
    const auto x = [](const std::vector<vec2> &points, uint by = 0) { return [&points, by](uint i) { return points[(i + by) % n].x; }; };
    const auto y = [](const std::vector<vec2> &points, uint by = 0) { return [&points, by](uint i) { return points[(i + by) % n].y; }; };
    EXPECT_NEAR(correlation(x(a), y(a)), 0, bound);
    if (GetParam() != "blue_noise") {  // whose neighbours are not
        EXPECT_NEAR(correlation(x(a), x(a, 1)), 0, bound);
        EXPECT_NEAR(correlation(y(a), y(a, 256)), 0, bound);
    }
    EXPECT_NEAR(correlation(x(a), x(other_seed)), 0, bound);
    EXPECT_NEAR(correlation(x(a), x(other_half)), 0, bound);
    EXPECT_NEAR(correlation(y(a), y(other_half)), 0, bound);
    EXPECT_NEAR(correlation(x(a), x(later)), 0, bound);
    // Uses, of the first samples of all pixels and of all samples of one.
    const std::vector<vec2> one = positions(GetParam(), pixels, first, 0, 1), two = positions(GetParam(), pixels, first, 0, 2);
    EXPECT_NEAR(correlation(x(a), x(one)), 0, bound);
    EXPECT_NEAR(correlation(x(one), x(two)), 0, bound);
    EXPECT_NEAR(correlation(y(one), x(two)), 0, bound);
    EXPECT_NEAR(correlation(x(one), y(one)), 0, bound);
    std::vector<uint> samples(n);
    for (uint i = 0; i < n; ++i) samples[i] = i;
    const std::vector<vec2> place = positions(GetParam(), first, samples, 0), three = positions(GetParam(), first, samples, 0, 3),
                            four = positions(GetParam(), first, samples, 0, 4);
    EXPECT_NEAR(correlation(x(place), x(three)), 0, bound);
    EXPECT_NEAR(correlation(x(three), x(four)), 0, bound);
    EXPECT_NEAR(correlation(y(three), y(four)), 0, bound);
}

/// The mean of n independent x is 1/2 with variance 1 / (12 n), n being 8; its square within 5 sqrt(2 / m) of that for m pixels, relatively.
TEST(Independent, MeansHaveTheVarianceOfIndependentNumbers) {
    for (const uint half : {0u, 1u}) {
        const RampError error = ramp_error("independent", half, 8, 64);
        const double variance = 1 / (12.0 * 8);
        EXPECT_NEAR(error.square, variance, 5 * std::sqrt(2.0 / 4096) * variance);
        EXPECT_NEAR(error.mean, 0, 5 * std::sqrt(variance / 4096));
    }
}

}  // namespace
}  // namespace brandung
