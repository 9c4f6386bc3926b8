/// kernels/filters and stages/weigh_samples.cl, with the tables of scene/filters.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/support/filters.h"
#include "tests/support/probe.h"
#include "tests/support/rendering.h"
#include "tests/support/statistics/chi_square.h"
#include "tests/support/statistics/significance.h"

namespace brandung {
namespace {

class FilterOf : public testing::TestWithParam<std::string> {
protected:
    const FilterKind &kind = filter_kinds()[filter_number(GetParam())];

    /// Distances from the pixel's centre.
    std::vector<double> offsets(const std::vector<float> &u, float radius) const {
        const std::string text = std::string("#include \"kernels/filters/") + kind.file + R"(.cl"
            kernel void probe(const global float *u, const global FilterParams *filter, const global float *table, global float *x) {
                x[get_global_id(0)] = filter_place(u[get_global_id(0)], *filter, table);
            })";
        std::vector<double> offsets;
        for (const float x : Probe(text).run<float>(u, filter_params(kind, radius), filter_table(kind, radius))) offsets.push_back(double(x) - 0.5);
        offsets.resize(u.size());
        return offsets;
    }
};

/// Counts in 40 cells of one width, against the filter's integrals.
TEST_P(FilterOf, PlacesAreDistributedAsTheFiltersMagnitude) {
    constexpr std::size_t n = 1 << 20, cells = 40;
    const double radius = kind.radius;
    std::mt19937 random(1);
    std::vector<float> u(n);
    for (float &x : u) x = float(random() >> 8) * 0x1p-24f;
    std::vector<std::uint64_t> counts(cells);
    for (const double x : offsets(u, kind.radius)) ++counts[std::min(std::size_t(std::max((x + radius) / (2 * radius), 0.0) * cells), cells - 1)];
    std::vector<double> expected;
    for (std::size_t i = 0; i < cells; ++i) {
        const double from = radius * (2 * double(i) / cells - 1), to = radius * (2 * double(i + 1) / cells - 1);
        expected.push_back(filter_integral(GetParam(), radius, from, to, true));
    }
    const statistics::ChiSquare test = statistics::chi_square(counts, expected);
    EXPECT_GE(test.degrees, 25);
    EXPECT_TRUE(statistics::plausible(test.p));
}

/// Strata of random numbers become strata of places.
TEST_P(FilterOf, PlacesAreInTheOrderOfTheirRandomNumbersAndWithinTheRadius) {
    std::vector<float> u = {0, 0x1p-149f, 0x1p-24f, std::nextafter(0.5f, 0.0f), 0.5f, std::nextafter(0.5f, 1.0f), 1 - 0x1p-24f};
    for (int i = 0; i <= 100000; ++i) u.push_back(float(i) / 100001);
    std::sort(u.begin(), u.end());
    const float radius = kind.has_radius ? 1.75f : kind.radius;
    const std::vector<double> x = offsets(u, radius);
    for (std::size_t i = 1; i < u.size(); ++i) ASSERT_LE(x[i - 1], x[i]) << u[i];
    EXPECT_GE(x.front(), -radius);
    EXPECT_LE(x.back(), radius);
    EXPECT_EQ(x[std::size_t(std::find(u.begin(), u.end(), 0.5f) - u.begin())], 0) << "the centre";
}

/// A table's nodes are where the filter's mass has been passed that they stand for.
TEST_P(FilterOf, NodesOfTheTableAreExact) {
    const double radius = kind.radius, mass = filter_integral(GetParam(), radius, 0, radius, true);
    const std::vector<float> table = filter_table(kind, kind.radius);
    for (std::size_t i = 0; i < table.size(); i += 64) {
        const double beyond = 1 - double(i) / FILTER_INTERVALS;
        EXPECT_NEAR(filter_integral(GetParam(), radius, table[i], radius, true) / mass, beyond * beyond, 2e-6) << i;
    }
}

TEST_P(FilterOf, PlacesBetweenNodesAreInterpolated) {
    if (!kind.tabulated) return;
    const std::vector<float> table = filter_table(kind, kind.radius);
    std::vector<float> u;
    for (uint i = 0; i < FILTER_INTERVALS; ++i) u.push_back(float(std::pow(1 - (i + 0.25) / FILTER_INTERVALS, 2) / 2));
    const std::vector<double> x = offsets(u, kind.radius);
    // u is rounded to 2^-25, and its root by half of that over the root, at most a thousandth of an interval's length of 2^-11; but near the end,
    // where intervals are long, by more.
    for (uint i = 0; i + 64 < FILTER_INTERVALS; ++i)
        ASSERT_NEAR(-x[i], 0.75 * double(table[i]) + 0.25 * double(table[i + 1]), 0.02 * double(table[i + 1] - table[i]) + 1e-6) << i;
}

TEST_P(FilterOf, SignsAndWeightsGiveTheFiltersIntegral) {
    const FilterParams params = filter_params(kind, kind.radius);
    const double norm = filter_norm(GetParam(), kind.radius);
    EXPECT_NEAR(params.weight * 0x1p-30, norm * norm, 1e-8);
    EXPECT_NEAR(norm * (1 - 2 * double(params.negative_tail)), 1, 1e-7);
    EXPECT_EQ(params.negative_tail > 0, GetParam() == "mitchell");
}

/// A tent's overlap with the next pixel's is a quarter of that with itself, and with those beyond nothing, in either direction.
TEST(CorrelatedPixels, AreThoseOfOverlappingFilters) {
    FilmSettings film;
    EXPECT_EQ(correlated_pixels(film), 1);
    film.filter = filter_number("tent"), film.filter_radius = 1;
    EXPECT_EQ(correlated_pixels(film), 1) << "drawn for one pixel each";
    film.splat = true;
    EXPECT_NEAR(correlated_pixels(film), std::pow(1 + 2.0 / 16, 2), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Kernels, FilterOf, testing::ValuesIn(filter_names()), [](const auto &info) { return info.param; });

/// value * weight / 2^30, halves away from 0.
__int128 weighed(__int128 value, uint weight) {
    const __int128 magnitude = (value < 0 ? -value : value) * weight, rounded = (magnitude + (1 << 29)) >> 30;
    return value < 0 ? -rounded : rounded;
}

Integer128 wide(__int128 x) { return {static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(x >> 64)}; }

/// Four samples of two pixels: which are negative follows from the sampler alone.
TEST(WeighSamples, MultipliesEachSampleByItsSignAndTheWeightExactly) {
    const Sources lists = {{"generated/sampler.cl", "#include \"kernels/samplers/sobol.cl\"\n"}};
    constexpr uint pixel_count = 64, samples = 4, count = pixel_count * samples;
    const BatchParams batch = {.pixels = pixel_count, .first_sample = 2, .samples = samples, .spp = 8, .seed = 3, .position = PIXEL_CENTER};
    const FilterParams filter = {.radius = 2, .negative_tail = 0.3f, .weight = 0x4c000001u};
    std::vector<uint> pixels, pixel_of, sample_of;
    std::vector<Sample> before;
    std::mt19937_64 random(7);
    for (uint p = 0; p < pixel_count; ++p) pixels.push_back(p % 8 | p / 8 << 16);
    for (uint i = 0; i < count; ++i) {
        pixel_of.push_back(pixels[i / samples]), sample_of.push_back(2 + i % samples);
        const auto channel = [&] { return wide(static_cast<std::int64_t>(random()) >> (15 + random() % 49)); };
        before.push_back({{channel(), channel(), channel()}});
    }
    // Products just below multiples of 2^64, where rounding carries.
    for (uint k = 1; k <= 16; ++k) before[k].sum[0] = wide(((__int128{k} << 64) - 1) / filter.weight);
    const std::vector<vec2> u = Probe(R"(#include "kernels/samplers/sobol.cl"
        kernel void probe(const global uint *pixels, const global uint *samples, const global BatchParams *batch, global vec2 *positions) {
            positions[get_global_id(0)] = sampler_pixel_position(pixels[get_global_id(0)], samples[get_global_id(0)], *batch);
        })")
                                    .run<vec2>(pixel_of, sample_of, batch);
    Device &device = test_device();
    const Buffer<Sample> after(device, before);
    Kernel(device, "kernels/stages/weigh_samples.cl", "weigh_samples", lists)(count, batch, filter, Buffer<uint>(device, pixels), count, after);
    const std::vector<Sample> results = after.read();
    std::size_t negative_ones = 0;
    for (uint i = 0; i < count; ++i) {
        const auto outside = [](float x) { return 2 * std::min(x, 1 - x) < 0.3f; };
        const bool negative = outside(u[i].x) != outside(u[i].y);
        negative_ones += negative;
        for (std::size_t c = 0; c < 3; ++c) {
            const __int128 expected = weighed(value_of(before[i].sum[c]), filter.weight);
            ASSERT_TRUE(value_of(results[i].sum[c]) == (negative ? -expected : expected)) << i;
        }
    }
    // 2 * 0.3 * 0.7 of them in expectation.
    EXPECT_NEAR(double(negative_ones) / count, 0.42, 0.15);
}

/// What add_samples cuts and counts must not become less bright here.
TEST(WeighSamples, WhatIsTooBrightStaysTooBright) {
    const Sources lists = {{"generated/sampler.cl", "#include \"kernels/samplers/sobol.cl\"\n"}};
    Device &device = test_device();
    const __int128 limit = __int128{1} << 49;
    const std::vector<Sample> before = {{{wide(limit), wide(limit + 1), wide(-(limit << 20))}}};
    const BatchParams batch = {.pixels = 1, .first_sample = 0, .samples = 1, .spp = 2};
    const FilterParams filter = {.radius = 2, .negative_tail = 0, .weight = 1u << 30};
    const Buffer<Sample> after(device, before);
    Kernel(device, "kernels/stages/weigh_samples.cl", "weigh_samples", lists)(1, batch, filter, Buffer<uint>(device, std::vector<uint>{0}), 1u,
                                                                              after);
    const Sample result = after.read()[0];
    EXPECT_TRUE(value_of(result.sum[0]) == limit);
    EXPECT_TRUE(value_of(result.sum[1]) == limit);
    EXPECT_TRUE(value_of(result.sum[2]) == -limit);
}

}  // namespace
}  // namespace brandung
