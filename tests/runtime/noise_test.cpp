/// runtime/wavefront/noise: estimates from films whose pixels' limits are known.
#include "runtime/wavefront/noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "runtime/opencl/kernel.h"

namespace brandung {
namespace {

using Generator = std::mt19937;

/// The limit of a pixel, and how its samples are drawn.
struct PixelModel {
    double limit;
    std::function<double(Generator &random, uint place, uint count)> sample;  ///< the place-th of `count` of a half
};

double uniform(Generator &random) { return std::uniform_real_distribution()(random); }

PixelModel normal(uint i) {
    const double limit = 0.2 + 0.8 * (i % 97) / 97, deviation = 0.2 * limit;
    return {limit, [=](Generator &random, uint, uint) { return std::normal_distribution(limit, deviation)(random); }};
}

/// As of a glass that shows one thing by reflection and another by refraction: kurtosis is low, and then high.
PixelModel two_values(uint i, double probability) {
    const double low = 0.5 + 0.3 * (i % 7) / 7;
    return {low + probability, [=](Generator &random, uint, uint) { return low + (uniform(random) < probability ? 1.0 : 0.0); }};
}

/// An edge through strata of one dimension: all are sure but one.
PixelModel stratified_edge(uint i) {
    const double edge = (i % 31 + 0.5) / 31;
    return {0.5 + edge, [=](Generator &random, uint place, uint count) { return 0.5 + ((place + uniform(random)) / count < edge ? 1 : 0); }};
}

Integer128 wide(__int128 x) { return {static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(x >> 64)}; }

FilmPixel pixel_of(const PixelModel &model, uint samples, Generator &random) {
    FilmPixel pixel{};
    __int128 sums[2] = {}, squares[2] = {};
    pixel.counts[0] = samples - samples / 2, pixel.counts[1] = samples / 2;
    for (uint i = 0; i < samples; ++i) {
        const __int128 value = std::llrint(std::ldexp(model.sample(random, i / 2, pixel.counts[i % 2]), 32));
        sums[i % 2] += value, squares[i % 2] += value * value;
    }
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t half : {0, 1}) pixel.sums[half][c] = wide(sums[half]), pixel.squares[half][c] = wide(squares[half]);
    return pixel;
}

double squared_error(const FilmPixel &pixel, double limit) {
    const auto sum_of_half = [&](std::size_t half) { return std::ldexp(double(std::int64_t(pixel.sums[half][0].low)), -32); };
    const double sum = sum_of_half(0) + sum_of_half(1), n = pixel.counts[0] + pixel.counts[1];
    return (sum / n - limit) * (sum / n - limit) / (limit * limit + 0.01);
}

/// How often intervals hold the error of their own picture, of 1600 pixels, and the mean estimate over the mean error.
struct Coverage {
    double inside, ratio;
};
Coverage coverage(const std::function<PixelModel(uint)> &model, uint samples) {
    constexpr uint runs = 1000, pixels = 1600;
    uint inside = 0;
    double estimates = 0, errors = 0;
    for (uint run = 0; run < runs; ++run) {
        Generator random(run);
        std::vector<FilmPixel> film;
        double error = 0;
        for (uint i = 0; i < pixels; ++i) {
            film.push_back(pixel_of(model(i), samples, random));
            error += squared_error(film.back(), model(i).limit) / pixels;
        }
        NoiseSums sums;
        sums.add(film);
        const Noise noise = sums.noise().value();
        inside += error >= noise.low() && error <= noise.high();
        estimates += noise.relmse, errors += error;
    }
    return {double(inside) / runs, estimates / errors};
}

/// 95 % of 1000 within three standard deviations of their number are 93 to 97 %.
void expect_coverage(const std::function<PixelModel(uint)> &model, uint samples, double bias) {
    const Coverage result = coverage(model, samples);
    EXPECT_GE(result.inside, 0.93) << samples << " samples";
    EXPECT_LE(result.inside, 0.97) << samples << " samples";
    EXPECT_NEAR(result.ratio, 1, bias) << samples << " samples";
}

TEST(Noise, IntervalsHoldTheErrorOfNormalSamples) {
    for (const uint samples : {4u, 17u}) expect_coverage(normal, samples, 0.01);
}

TEST(Noise, IntervalsHoldTheErrorOfSamplesOfTwoValues) {
    expect_coverage([](uint i) { return two_values(i, 0.5); }, 8, 0.03);
    expect_coverage([](uint i) { return two_values(i, 0.1); }, 16, 0.02);
}

TEST(Noise, IntervalsHoldTheErrorOfStratifiedSamples) {
    for (const uint samples : {8u, 32u}) expect_coverage(stratified_edge, samples, 0.02);
}

/// Two samples say nothing of their distribution.
TEST(Noise, IntervalsOfTwoSamplesAreSafe) {
    for (const auto &model : std::vector<std::function<PixelModel(uint)>>{normal, [](uint i) { return two_values(i, 0.5); }})
        EXPECT_GE(coverage(model, 2).inside, 0.97);
}

TEST(Noise, OfNoTwoSamplesThereIsNone) {
    EXPECT_FALSE(NoiseSums().noise());
    NoiseSums sums;
    Generator random(1);
    sums.add(std::vector<FilmPixel>{pixel_of(normal(0), 1, random), FilmPixel{}});
    EXPECT_FALSE(sums.noise());
}

TEST(Noise, OfEqualSamplesIsNothing) {
    Generator random(1);
    NoiseSums sums;
    sums.add(std::vector<FilmPixel>(9, pixel_of({0.7, [](Generator &, uint, uint) { return 0.7; }}, 6, random)));
    EXPECT_EQ(sums.noise().value().relmse, 0);
    EXPECT_EQ(sums.noise().value().half_width, 0);
}

/// By hand: each half has the samples 1 and 0 and its mean the variance (1 - 1/2) / (1 * 2) = 1/4; that of both means is 2 (1/4) / 4 = 1/8.
TEST(Noise, StandardErrorIsThatOfTheSamples) {
    const PixelModel model{0.5, [](Generator &, uint place, uint) { return place == 0 ? 1.0 : 0.0; }};
    Generator random(1);
    const vec3 error = standard_error(pixel_of(model, 4, random));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(error[c], std::sqrt(1.0 / 8), 1e-7);
    EXPECT_EQ(standard_error(FilmPixel{}), vec3(0));
}

/// The film is summed in parallel and in parts: the same pixels give the same bits.
TEST(Noise, PartsAddUp) {
    Generator random(3);
    std::vector<FilmPixel> film;
    for (uint i = 0; i < 20000; ++i) film.push_back(pixel_of(two_values(i, 0.3), 4, random));
    NoiseSums whole, parts;
    whole.add(film);
    for (const std::size_t first : {0, 7000}) parts.add(std::span(film).subspan(first, first == 0 ? 7000 : 13000));
    EXPECT_NEAR(whole.noise()->relmse, parts.noise()->relmse, 1e-12);
    EXPECT_NEAR(whole.noise()->half_width, parts.noise()->half_width, 1e-12);
    NoiseSums again;
    again.add(film);
    EXPECT_EQ(whole.noise()->relmse, again.noise()->relmse);
}

}  // namespace
}  // namespace brandung
