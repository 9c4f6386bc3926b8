/// kernels/samplers/sobol.cl.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/kernels/samplers/positions.h"

namespace brandung {
namespace {

/// Pascal's triangle modulo 2, row by row: digit i is the sum of the index's bits j with odd j over i.
uint second_digits(uint index) {
    bool odd[32][32] = {};
    for (uint j = 0; j < 32; ++j)
        for (uint i = 0; i <= j; ++i) odd[j][i] = i == 0 || i == j || (odd[j - 1][i - 1] != odd[j - 1][i]);
    uint digits = 0;
    for (uint j = 0; j < 32; ++j)
        for (uint i = 0; i <= j; ++i) digits ^= uint{(index >> j & 1u) != 0 && odd[j][i]} << i;
    return digits;
}

TEST(Sobol, TheSecondCoordinatesDigitsAreThoseOfPascalsMatrix) {
    std::vector<uint> indices = {0, 1, 2, 3, 0x80000000u, 0xffffffffu, 0x12345678u};
    for (uint i = 0; i < 32; ++i) indices.push_back(1u << i);
    const std::vector<uint> digits = Probe(R"(#include "kernels/samplers/sobol.cl"
        kernel void probe(const global uint *x, global uint *y) { y[get_global_id(0)] = sobol_second_digits(x[get_global_id(0)]); })")
                                         .run<uint>(indices);
    for (std::size_t i = 0; i < indices.size(); ++i) EXPECT_EQ(digits[i], second_digits(indices[i])) << std::hex << indices[i];
}

/// Where two numbers differ first, their scrambled digits do: scrambling permutes the halves of every interval of digits (Owen 1995).
TEST(Sobol, ScramblingKeepsIntervalsOfDigitsTogether) {
    std::vector<uint> digits, seeds;
    for (uint i = 0; i < 4096; ++i)
        for (const bool flips : {false, true}) {
            const uint same = i % 23;  // leading digits
            digits.push_back(i * 0x9e3779b9u ^ (flips ? 1u << same | (i * 0x7feb352du & ~0u << same) : 0u)), seeds.push_back(i * 0x85ebca6bu);
        }
    const std::vector<float> x = Probe(R"(#include "kernels/samplers/sobol.cl"
        kernel void probe(const global uint *digits, const global uint *seeds, global float *x) {
            x[get_global_id(0)] = unit_interval(bits_reversed(owen_scrambled(digits[get_global_id(0)], seeds[get_global_id(0)])));
        })")
                                     .run<float>(digits, seeds);
    for (std::size_t i = 0; i < x.size(); i += 2) {
        const int same = int(i / 2 % 23);
        const auto cell = [&](std::size_t k, int count) { return uint(std::ldexp(x[k], count)); };
        ASSERT_EQ(cell(i, same), cell(i + 1, same)) << i;
        ASSERT_NE(cell(i, same + 1), cell(i + 1, same + 1)) << i;
    }
}

/// The first 2^k samples of each half, in boxes of 2^-a by 2^-(k - a).
TEST(Sobol, EveryBoxHasOneOfTheFirstSamplesOfEachHalf) {
    for (const uint pixel : {0u, 123u | 45u << 16, 65534u | 65534u << 16})
        for (const uint half : {0u, 1u})
            for (uint k = 0; k <= 10; ++k) {
                const uint n = 1u << k;
                std::vector<uint> samples(n), pixels(n, pixel);
                for (uint i = 0; i < n; ++i) samples[i] = 2 * i + half;
                const std::vector<vec2> points = positions("sobol", pixels, samples, 9);
                for (uint a = 0; a <= k; ++a) {
                    std::set<uint> boxes;
                    for (const vec2 &p : points) boxes.insert(uint(std::ldexp(p.x, int(a))) | uint(std::ldexp(p.y, int(k - a))) << 16);
                    ASSERT_EQ(boxes.size(), n) << pixel << ", half " << half << ", " << a << " of " << k;
                }
            }
}

/// The same of each use of a path, whose points come in another order.
TEST(Sobol, EveryBoxHasOneOfTheFirstPairsOfEveryUse) {
    constexpr uint k = 6, n = 1u << k;
    std::vector<uint> samples(n);
    for (uint i = 0; i < n; ++i) samples[i] = 2 * i;
    for (const uint dimension : {1u, 2u, 3u, 77u}) {
        const std::vector<vec2> points = positions("sobol", std::vector<uint>(n, 123u | 45u << 16), samples, 9, dimension);
        for (uint a = 0; a <= k; ++a) {
            std::set<uint> boxes;
            for (const vec2 &p : points) boxes.insert(uint(std::ldexp(p.x, int(a))) | uint(std::ldexp(p.y, int(k - a))) << 16);
            ASSERT_EQ(boxes.size(), n) << dimension << ", " << a << " of " << k;
        }
    }
}

/// One of n = 2^k samples in each of n columns has variance 1 / (12 n²) about the column's centre, the mean of n such 1 / (12 n³); its square over m
/// pixels within 5 sqrt(2 / m) of that, relatively: sqrt(2 / m) is the deviation for normal means, and less for uniform ones. The mean of them all
/// is 1/2 within 5 standard deviations, p < 1e-6.
TEST(Sobol, EachHalfAloneIsAnUnbiasedStratifiedEstimate) {
    for (const uint n : {1u, 2u, 4u, 8u, 32u})
        for (const uint half : {0u, 1u}) {
            const RampError error = ramp_error("sobol", half, n, 64);
            const double variance = 1 / (12.0 * n * n * n);
            EXPECT_NEAR(error.square, variance, 5 * std::sqrt(2.0 / 4096) * variance) << n << ", half " << half;
            EXPECT_NEAR(error.mean, 0, 5 * std::sqrt(variance / 4096)) << n << ", half " << half;
        }
}

/// So that a render may end after any: their means are unbiased, and have less than half the variance of independent ones, 1 / (12 n).
TEST(Sobol, AnyNumberOfSamplesIsAnUnbiasedEstimate) {
    for (const uint n : {3u, 5u, 7u, 21u}) {
        const RampError error = ramp_error("sobol", 0, n, 64);
        EXPECT_NEAR(error.mean, 0, 5 * std::sqrt(error.square / 4096)) << n;
        EXPECT_LT(error.square, 0.5 / (12.0 * n)) << n;
    }
}

}  // namespace
}  // namespace brandung
