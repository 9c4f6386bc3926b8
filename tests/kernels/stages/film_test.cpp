/// kernels/stages/add_samples.cl and develop.cl, as runtime/wavefront/film.h runs them.
#include "runtime/wavefront/film.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <random>

#include "tests/support/probe.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

constexpr std::int64_t clamp_of_samples = std::int64_t{1} << 48;  // 2^16 in units of 2^-32
constexpr uint width = 37, height = 11;

uint pixel_at(uint x, uint y) { return x | y << 16; }

/// Samples `first` ... of some pixels.
struct Part {
    std::vector<uint> pixels;
    uint first, samples;
    std::vector<Sample> sums;  ///< pixel by pixel
};

void add(Film &film, const Part &part) {
    Device &device = test_device();
    const Buffer<uint> pixels(device, part.pixels);
    const BatchParams params{
        .pixels = uint(part.pixels.size()), .first_sample = part.first, .samples = part.samples, .spp = 64, .columns = {8, 8}, .rows = {4, 4}};
    const std::vector<uint> outside;
    film.add(Batch{.params = params, .pixels = pixels, .camera = {}, .interior = outside}, Buffer<Sample>(device, part.sums));
}

Part random_part(uint seed, uint first, uint samples, const std::vector<uint> &pixels) {
    std::mt19937_64 random(seed);
    Part part{pixels, first, samples, {}};
    for (std::size_t i = 0; i < pixels.size() * samples; ++i) {
        Sample sample{};
        for (auto &sum : sample.sum) sum = static_cast<std::int64_t>(random()) >> (random() % 60);
        part.sums.push_back(sample);
    }
    return part;
}

std::vector<uint> all_pixels() {
    std::vector<uint> pixels;
    for (uint y = 0; y < height; ++y)
        for (uint x = 0; x < width; ++x) pixels.push_back(pixel_at(x, y));
    return pixels;
}

/// What a pixel should hold, in 128 bits.
struct Expected {
    std::array<std::int64_t, 3> sum{}, odd{};
    std::array<unsigned __int128, 3> squares{};
    uint count = 0, odd_count = 0, clamped = 0;
};

void add(std::vector<Expected> &film, const Part &part) {
    for (std::size_t i = 0; i < part.pixels.size(); ++i) {
        Expected &pixel = film[(part.pixels[i] >> 16) * width + (part.pixels[i] & 0xffff)];
        for (uint j = 0; j < part.samples; ++j) {
            const bool odd = (part.first + j) % 2;
            bool cut = false;
            for (std::size_t c = 0; c < 3; ++c) {
                const std::int64_t sum = part.sums[i * part.samples + j].sum[c];
                const std::int64_t value = std::min(std::max(sum, -clamp_of_samples), clamp_of_samples);
                cut |= value != sum;
                pixel.sum[c] += value;
                if (odd) pixel.odd[c] += value;
                pixel.squares[c] += static_cast<unsigned __int128>(static_cast<__int128>(value) * value);
            }
            ++pixel.count, pixel.odd_count += odd, pixel.clamped += cut;
        }
    }
}

void expect_equal(const Film &film, const std::vector<Expected> &expected) {
    const std::vector<FilmPixel> pixels = film.read();
    uint clamped = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            ASSERT_EQ(pixels[i].sum[c], expected[i].sum[c]) << i;
            ASSERT_EQ(pixels[i].odd[c], expected[i].odd[c]) << i;
            ASSERT_EQ(pixels[i].squares[c][0], static_cast<std::uint64_t>(expected[i].squares[c])) << i;
            ASSERT_EQ(pixels[i].squares[c][1], static_cast<std::uint64_t>(expected[i].squares[c] >> 64)) << i;
        }
        ASSERT_EQ(pixels[i].count, expected[i].count) << i;
        ASSERT_EQ(pixels[i].odd_count, expected[i].odd_count) << i;
        clamped += expected[i].clamped;
    }
    EXPECT_EQ(film.clamped(), clamped);
}

TEST(Film, SumsHalvesAndSquaresAreExactOverSeveralBatches) {
    Film film(test_device(), width, height);
    std::vector<Expected> expected(width * height);
    const std::vector<uint> all = all_pixels(), some(all.begin() + 5, all.begin() + 200);
    for (const Part &part : {random_part(1, 0, 16, all), random_part(2, 16, 3, some), random_part(3, 19, 5, all), random_part(4, 24, 1, some)})
        add(film, part), add(expected, part);
    expect_equal(film, expected);
}

TEST(Film, ManySquaresCarryIntoTheUpperHalf) {
    Film film(test_device(), 1, 1);
    const Sample largest{{clamp_of_samples, -clamp_of_samples, (std::int64_t{1} << 32) - 1}};
    const uint samples = 1000;
    add(film, {{0}, 0, samples, std::vector<Sample>(samples, largest)});
    const FilmPixel pixel = film.read()[0];
    // (2^48)^2 * 1000 = 1000 * 2^96: the lower half is 0, the upper 1000 * 2^32.
    for (const uint c : {0u, 1u}) {
        EXPECT_EQ(pixel.squares[c][0], 0u);
        EXPECT_EQ(pixel.squares[c][1], 1000ull << 32);
    }
    // (2^32 - 1)^2 = 2^64 - 2^33 + 1, a thousand times: 1000 * 2^64 - 1000 * (2^33 - 1).
    EXPECT_EQ(pixel.squares[2][0], 0 - 1000ull * ((1ull << 33) - 1));
    EXPECT_EQ(pixel.squares[2][1], 999u);
    EXPECT_EQ(film.clamped(), 0u);
}

TEST(Film, TooBrightSamplesAreCutAndCountedOnce) {
    Film film(test_device(), 2, 1);
    const std::int64_t most = std::numeric_limits<std::int64_t>::max();
    add(film,
        {{pixel_at(0, 0), pixel_at(1, 0)}, 0, 2, {{{clamp_of_samples, 0, 0}}, {{clamp_of_samples + 1, -most - 1, 7}}, {{0, 0, most}}, {{1, 1, 1}}}});
    EXPECT_EQ(film.clamped(), 2u);
    const std::vector<FilmPixel> pixels = film.read();
    EXPECT_EQ(pixels[0].sum[0], 2 * clamp_of_samples);
    EXPECT_EQ(pixels[0].sum[1], -clamp_of_samples);
    EXPECT_EQ(pixels[0].sum[2], 7);
    EXPECT_EQ(pixels[1].sum[2], clamp_of_samples + 1);
}

TEST(Film, TheOrderOfBatchesAndPixelsDoesNotShow) {
    std::vector<uint> forwards = all_pixels(), backwards(forwards.rbegin(), forwards.rend());
    const Part first = random_part(5, 0, 4, forwards), second = random_part(6, 4, 3, forwards);
    Part reversed{backwards, 0, 4, {}};
    for (std::size_t i = forwards.size(); i-- > 0;)
        reversed.sums.insert(reversed.sums.end(), first.sums.begin() + long(4 * i), first.sums.begin() + long(4 * i + 4));
    Film a(test_device(), width, height), b(test_device(), width, height);
    add(a, first), add(a, second);
    add(b, second), add(b, reversed);
    const std::vector<FilmPixel> left = a.read(), right = b.read();
    EXPECT_EQ(std::memcmp(left.data(), right.data(), left.size() * sizeof(FilmPixel)), 0);
}

TEST(Film, DevelopGivesTheMeanAndBlackWithoutSamples) {
    Film film(test_device(), width, height);
    std::vector<Expected> expected(width * height);
    const std::vector<uint> all = all_pixels(), most(all.begin(), all.end() - 3);
    const Part part = random_part(7, 0, 7, most);
    add(film, part), add(expected, part);
    const std::vector<vec3> picture = film.develop();
    for (std::size_t i = 0; i < picture.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const long double mean = expected[i].count ? static_cast<long double>(expected[i].sum[c]) * 0x1p-32L / expected[i].count : 0;
            // The sum, the reciprocal of the count and their product are rounded once each: 3 u.
            ASSERT_LE(std::abs(static_cast<long double>(picture[i][int(c)]) - mean), 3.01L * 0x1p-24L * std::abs(mean)) << i;
        }
    for (std::size_t i = most.size(); i < all.size(); ++i) EXPECT_EQ(picture[i], vec3(0));
}

}  // namespace
}  // namespace brandung
