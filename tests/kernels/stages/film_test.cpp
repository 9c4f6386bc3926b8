/// kernels/stages/add_samples.cl and develop.cl, as runtime/wavefront/film.h runs them.
#include "runtime/wavefront/film.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <random>

#include "tests/support/probe.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

constexpr __int128 clamp_of_samples = __int128{1} << 48;  // 2^16 in units of 2^-32
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
    const BatchParams params{.pixels = uint(part.pixels.size()), .first_sample = part.first, .samples = part.samples, .spp = 64};
    const std::vector<uint> outside;
    const Buffer<MotionPart> at_rest(device, 0);
    film.add(Batch{.params = params, .pixels = pixels, .camera = {}, .shutter = {}, .camera_motion = at_rest, .interior = outside},
             Buffer<Sample>(device, part.sums));
}

Integer128 wide(__int128 x) { return {static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(x >> 64)}; }

Sample make_sample(__int128 red, __int128 green, __int128 blue) { return {{wide(red), wide(green), wide(blue)}}; }

Part random_part(uint seed, uint first, uint samples, const std::vector<uint> &pixels) {
    std::mt19937_64 random(seed);
    Part part{pixels, first, samples, {}};
    for (std::size_t i = 0; i < pixels.size() * samples; ++i) {
        const auto channel = [&] { return static_cast<std::int64_t>(random()) >> (random() % 60); };
        part.sums.push_back(make_sample(channel(), channel(), channel()));
    }
    return part;
}

std::vector<uint> all_pixels() {
    std::vector<uint> pixels;
    for (uint y = 0; y < height; ++y)
        for (uint x = 0; x < width; ++x) pixels.push_back(pixel_at(x, y));
    return pixels;
}

/// What a pixel should hold.
struct Expected {
    std::array<std::array<__int128, 3>, 2> sums{}, squares{};
    std::array<uint, 2> counts{};
    uint clamped = 0;
    __int128 sum(std::size_t c) const { return sums[0][c] + sums[1][c]; }
};

void add(std::vector<Expected> &film, const Part &part) {
    for (std::size_t i = 0; i < part.pixels.size(); ++i) {
        Expected &pixel = film[(part.pixels[i] >> 16) * width + (part.pixels[i] & 0xffff)];
        for (uint j = 0; j < part.samples; ++j) {
            const uint half = (part.first + j) % 2;
            bool cut = false;
            for (std::size_t c = 0; c < 3; ++c) {
                const __int128 sum = value_of(part.sums[i * part.samples + j].sum[c]);
                const __int128 value = std::min(std::max(sum, -clamp_of_samples), clamp_of_samples);
                cut |= value != sum;
                pixel.sums[half][c] += value;
                pixel.squares[half][c] += value * value;
            }
            ++pixel.counts[half], pixel.clamped += cut;
        }
    }
}

void expect_equal(const Film &film, const std::vector<Expected> &expected) {
    const std::vector<FilmPixel> pixels = film.read();
    uint clamped = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            for (const uint half : {0u, 1u}) {
                ASSERT_TRUE(value_of(pixels[i].sums[half][c]) == expected[i].sums[half][c]) << i << ", half " << half;
                ASSERT_TRUE(value_of(pixels[i].squares[half][c]) == expected[i].squares[half][c]) << i << ", half " << half;
            }
        }
        for (const uint half : {0u, 1u}) ASSERT_EQ(pixels[i].counts[half], expected[i].counts[half]) << i << ", half " << half;
        clamped += expected[i].clamped;
    }
    EXPECT_EQ(film.clamped(), clamped);
}

TEST(Film, SumsHalvesAndSquaresAreExactOverSeveralBatches) {
    Film film(test_device(), Window{0, 0, width, height});
    std::vector<Expected> expected(width * height);
    const std::vector<uint> all = all_pixels(), some(all.begin() + 5, all.begin() + 200);
    for (const Part &part : {random_part(1, 0, 16, all), random_part(2, 16, 3, some), random_part(3, 19, 5, all), random_part(4, 24, 1, some)})
        add(film, part), add(expected, part);
    expect_equal(film, expected);
}

/// 2^16 of the largest samples, as the brightest background gives; 64 bits hold 2^15 of them.
TEST(Film, SumsOfTheLargestSamplesDoNotWrap) {
    Film film(test_device(), Window{0, 0, 1, 1});
    constexpr uint samples = 1 << 14, batches = 4;
    const Sample largest = make_sample(clamp_of_samples, -clamp_of_samples, (std::int64_t{1} << 32) - 1);
    for (uint batch = 0; batch < batches; ++batch) add(film, {{0}, batch * samples, samples, std::vector<Sample>(samples, largest)});
    const FilmPixel pixel = film.read()[0];
    const __int128 count = samples * batches, one = (std::int64_t{1} << 32) - 1;
    for (const uint half : {0u, 1u}) {
        EXPECT_TRUE(value_of(pixel.sums[half][0]) == count / 2 * clamp_of_samples);
        EXPECT_TRUE(value_of(pixel.sums[half][1]) == -(count / 2 * clamp_of_samples));
        EXPECT_TRUE(value_of(pixel.sums[half][2]) == count / 2 * one);
        for (const uint c : {0u, 1u}) EXPECT_TRUE(value_of(pixel.squares[half][c]) == count / 2 * clamp_of_samples * clamp_of_samples);
        EXPECT_TRUE(value_of(pixel.squares[half][2]) == count / 2 * one * one);
        EXPECT_EQ(pixel.counts[half], count / 2);
    }
    EXPECT_EQ(film.clamped(), 0u);
    EXPECT_EQ(film.develop()[0], vec3(65536, -65536, 1));
}

/// The same sums after 2^24 samples, as they stand in a pixel.
TEST(Film, TheMostSamplesThereCanBeAreDeveloped) {
    Device &device = test_device();
    const std::int64_t half_count = std::int64_t{1} << 23;
    FilmPixel pixel{};
    for (const uint half : {0u, 1u}) {
        pixel.sums[half][0] = wide(half_count * clamp_of_samples), pixel.sums[half][1] = wide(-(half_count * clamp_of_samples));
        pixel.sums[half][2] = wide(half_count * (half == 0 ? 1 : -3)), pixel.counts[half] = uint(half_count);
    }
    const Buffer<vec3> picture(device, 1);
    Kernel(device, "kernels/stages/develop.cl", "develop", {})(1, 1u, Buffer<FilmPixel>(device, std::span(&pixel, 1)), picture);
    EXPECT_EQ(picture.read()[0], vec3(65536, -65536, -0x1p-32f));
}

TEST(Film, TooBrightSamplesAreCutAndCountedOnce) {
    Film film(test_device(), Window{0, 0, 2, 2});
    const __int128 most = std::numeric_limits<std::int64_t>::max(), beyond = (__int128{1} << 64) + clamp_of_samples;
    add(film, {{pixel_at(0, 0), pixel_at(1, 0), pixel_at(0, 1)},
               0,
               2,
               {make_sample(clamp_of_samples, 0, 0), make_sample(clamp_of_samples + 1, -most - 1, 7), make_sample(0, 0, most), make_sample(1, 1, 1),
                make_sample(beyond, 0, 0), make_sample(0, -beyond, 0)}});
    EXPECT_EQ(film.clamped(), 4u);
    const std::vector<FilmPixel> pixels = film.read();
    EXPECT_TRUE(sum_of(pixels[0], 0) == 2 * clamp_of_samples);
    EXPECT_TRUE(sum_of(pixels[0], 1) == -clamp_of_samples);
    EXPECT_TRUE(sum_of(pixels[0], 2) == 7);
    EXPECT_TRUE(sum_of(pixels[1], 2) == clamp_of_samples + 1);
    EXPECT_TRUE(sum_of(pixels[2], 0) == clamp_of_samples);
    EXPECT_TRUE(sum_of(pixels[2], 1) == -clamp_of_samples);
}

TEST(Film, TheOrderOfBatchesAndPixelsDoesNotShow) {
    std::vector<uint> forwards = all_pixels(), backwards(forwards.rbegin(), forwards.rend());
    const Part first = random_part(5, 0, 4, forwards), second = random_part(6, 4, 3, forwards);
    Part reversed{backwards, 0, 4, {}};
    for (std::size_t i = forwards.size(); i-- > 0;)
        reversed.sums.insert(reversed.sums.end(), first.sums.begin() + long(4 * i), first.sums.begin() + long(4 * i + 4));
    Film a(test_device(), Window{0, 0, width, height}), b(test_device(), Window{0, 0, width, height});
    add(a, first), add(a, second);
    add(b, second), add(b, reversed);
    const std::vector<FilmPixel> left = a.read(), right = b.read();
    EXPECT_EQ(std::memcmp(left.data(), right.data(), left.size() * sizeof(FilmPixel)), 0);
}

/// Bands of every number of rows, the last one shorter; batches reach over several.
TEST(Film, InBandsIsTheSame) {
    std::vector<Expected> expected(width * height);
    const std::vector<uint> all = all_pixels(), some(all.begin() + 5, all.begin() + 200);
    const Part first = random_part(8, 0, 5, all), second = random_part(9, 5, 2, some);
    add(expected, first), add(expected, second);
    Film whole(test_device(), Window{0, 0, width, height});
    add(whole, first), add(whole, second);
    const std::vector<vec3> picture = whole.develop();
    for (const std::size_t rows : {0u, 1u, 2u, 4u, 10u, 11u, 100u}) {
        Film film(test_device(), Window{0, 0, width, height}, (rows * width + width / 2) * sizeof(FilmPixel));
        add(film, first), add(film, second);
        expect_equal(film, expected);
        EXPECT_EQ(film.develop(), picture) << rows;
        EXPECT_LE(film.bytes(), whole.bytes());
    }
}

TEST(Film, LargerThanTheDevicesMemoryIsRefusedWithTheSizes) {
    try {
        Film(test_device(), Window{0, 0, 65535, 65535});
        ADD_FAILURE() << "not refused";
    } catch (const Error &error) {
        EXPECT_NE(std::string(error.what()).find("a film of 65535 x 65535 pixels takes 868"), std::string::npos) << error.what();
    }
}

TEST(Film, DevelopGivesTheMeanAndBlackWithoutSamples) {
    Film film(test_device(), Window{0, 0, width, height});
    std::vector<Expected> expected(width * height);
    const std::vector<uint> all = all_pixels(), most(all.begin(), all.end() - 3);
    const Part part = random_part(7, 0, 7, most);
    add(film, part), add(expected, part);
    const std::vector<vec3> picture = film.develop();
    for (std::size_t i = 0; i < picture.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const uint count = expected[i].counts[0] + expected[i].counts[1];
            const long double mean = count ? static_cast<long double>(expected[i].sum(c)) * 0x1p-32L / count : 0;
            // The sum, the reciprocal of the count and their product are rounded once each: 3 u.
            ASSERT_LE(std::abs(static_cast<long double>(picture[i][int(c)]) - mean), 3.01L * 0x1p-24L * std::abs(mean)) << i;
        }
    for (std::size_t i = most.size(); i < all.size(); ++i) EXPECT_EQ(picture[i], vec3(0));
}

}  // namespace
}  // namespace brandung
