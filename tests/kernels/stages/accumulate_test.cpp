/// kernels/stages/accumulate.cl: contributions become exact sums.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "kernels/core/items.h"
#include "tests/support/probe.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity(), not_a_number = std::numeric_limits<float>::quiet_NaN();

struct Sums {
    std::vector<Sample> samples;
    uint refused;
};

/// Item i adds contributions[i] to sample slots[i]. `branching` 2 allows items to share samples.
Sums accumulate(const std::vector<Spectrum> &contributions, const std::vector<uint> &slots, uint samples, uint branching = 2) {
    Device &device = test_device();
    Kernel kernel(device, "kernels/stages/accumulate.cl", "accumulate",
                  {{"generated/constants.h", "#pragma once\n#define BRANCHING " + std::to_string(branching) + "u\n#define INTERIOR_SIZE 1u\n"}});
    // The paths lie in reverse order, and the list begins after an entry that isn't part of the wave.
    const uint count = uint(contributions.size());
    std::vector<Path> paths(count);
    std::vector<uint> live(count + 1, 0);
    for (uint i = 0; i < count; ++i) paths[count - 1 - i].slot = slots[i], live[i + 1] = count - 1 - i;
    Buffer<Sample> sums(device, samples);
    Buffer<uint> refused(device, 1);
    sums.fill_zero(), refused.fill_zero();
    kernel(count, Buffer<uint>(device, live), 1u, count, Buffer<Path>(device, paths), Buffer<Spectrum>(device, contributions), sums, refused);
    return {sums.read(), refused.read()[0]};
}

/// In units of 2^-32: a float times 2^32 is exact in double.
std::int64_t fixed_point(float x) { return static_cast<std::int64_t>(std::nearbyint(static_cast<double>(x) * 0x1p32)); }

Sums accumulate_one(Spectrum contribution) { return accumulate({contribution}, {0}, 1); }

TEST(Accumulate, ContributionsAreRoundedToTheNearestUnitTiesToEven) {
    const float unit = 0x1p-32f;
    for (const auto &[x, units] : {std::pair{1.0f, std::int64_t{1} << 32},
                                   {unit, std::int64_t{1}},
                                   {0.5f * unit, std::int64_t{0}},
                                   {1.5f * unit, std::int64_t{2}},
                                   {2.5f * unit, std::int64_t{2}},
                                   {0.75f * unit, std::int64_t{1}},
                                   {-1.5f * unit, std::int64_t{-2}},
                                   {-1.0f, -(std::int64_t{1} << 32)},
                                   {0.0f, std::int64_t{0}},
                                   {0x1.fffffep15f, std::int64_t{0x1fffffe} << 23}}) {
        EXPECT_TRUE(value_of(accumulate_one({x, 0, 0}).samples[0].sum[0]) == units) << x;
    }
}

TEST(Accumulate, SumsAreExactAndEachChannelIsItsOwn) {
    Random random(1);
    std::vector<Spectrum> contributions;
    std::vector<uint> slots;
    std::vector<std::array<std::int64_t, 3>> expected(1000);
    for (uint i = 0; i < 100'000; ++i) {
        const float scale = std::exp2(random.uniform(-34, 10));
        contributions.push_back(random.in_cube(1) * scale);
        slots.push_back(random.below(1000));
        for (int c = 0; c < 3; ++c) expected[slots[i]][std::size_t(c)] += fixed_point(contributions[i][c]);
    }
    const Sums sums = accumulate(contributions, slots, 1000);
    EXPECT_EQ(sums.refused, 0u);
    for (uint s = 0; s < 1000; ++s)
        for (uint c = 0; c < 3; ++c) ASSERT_TRUE(value_of(sums.samples[s].sum[c]) == expected[s][c]) << s;
}

TEST(Accumulate, TheOrderDoesNotShowThoughAllShareOneSample) {
    Random random(2);
    std::vector<Spectrum> contributions;
    for (uint i = 0; i < 100'000; ++i) contributions.push_back(random.in_cube(1) * std::exp2(random.uniform(-20, 5)));
    const std::vector<uint> slots(contributions.size(), 0);
    const Sample first = accumulate(contributions, slots, 1).samples[0];
    std::reverse(contributions.begin(), contributions.end());
    const Sample second = accumulate(contributions, slots, 1).samples[0];
    for (uint c = 0; c < 3; ++c) {
        std::int64_t expected = 0;
        for (const Spectrum &contribution : contributions) expected += fixed_point(contribution[int(c)]);
        EXPECT_TRUE(value_of(first.sum[c]) == expected);
        EXPECT_TRUE(value_of(second.sum[c]) == expected);
    }
}

TEST(Accumulate, WithoutBranchingTheSumsAreTheSame) {
    Random random(3);
    std::vector<Spectrum> contributions;
    std::vector<uint> slots(1000);
    std::iota(slots.begin(), slots.end(), 0u);
    for (uint i = 0; i < 1000; ++i) contributions.push_back(random.in_cube(100));
    for (const uint branching : {0u, 1u}) {
        const Sums sums = accumulate(contributions, slots, 1000, branching);
        for (uint i = 0; i < 1000; ++i)
            for (uint c = 0; c < 3; ++c) ASSERT_TRUE(value_of(sums.samples[i].sum[c]) == fixed_point(contributions[i][int(c)]));
    }
}

TEST(Accumulate, WhatIsNotFiniteIsRefusedAndCountedAndLeavesTheRestAlone) {
    const std::vector<Spectrum> contributions = {
        {1, 1, 1}, {not_a_number, 1, 1}, {1, infinity, 1}, {1, 1, -infinity}, {infinity, -infinity, 0}, {not_a_number, 0, infinity}, {2, 2, 2}};
    const Sums sums = accumulate(contributions, std::vector<uint>(contributions.size(), 0), 1);
    EXPECT_EQ(sums.refused, 5u);
    for (uint c = 0; c < 3; ++c) EXPECT_TRUE(value_of(sums.samples[0].sum[c]) == std::int64_t{3} << 32);
}

TEST(Accumulate, HugeContributionsNeitherWrapNorChangeSign) {
    // 2^17 in units of 2^-32, where contributions are cut: 2^14 of them are 2^63 units, which 64 bits do not hold.
    const __int128 most = static_cast<__int128>(1) << 49;
    for (const uint count : {1u, 2u, 3u, 64u, 16383u, 16384u, 40000u})
        for (const float x : {0x1p17f, 0x1p29f, 0x1p30f, 1e20f, 3e38f}) {
            const Sums bright = accumulate(std::vector<Spectrum>(count, {x, 0, -x}), std::vector<uint>(count, 0), 1);
            EXPECT_TRUE(value_of(bright.samples[0].sum[0]) == count * most) << count << " times " << x;
            EXPECT_TRUE(value_of(bright.samples[0].sum[1]) == 0) << count << " times " << x;
            EXPECT_TRUE(value_of(bright.samples[0].sum[2]) == -(count * most)) << count << " times " << -x;
        }
}

}  // namespace
}  // namespace brandung
