/// kernels/stages/add_splats.cl and develop_splats.cl, as runtime/wavefront/film.h runs them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "runtime/wavefront/film.h"
#include "runtime/wavefront/pixel_halves.h"
#include "tests/support/filters.h"
#include "tests/support/probe.h"
#include "tests/support/rendering.h"

namespace brandung {
namespace {

constexpr uint width = 11, height = 7, spp = 24;
const Sources lists = {{"generated/sampler.cl", "#include \"kernels/samplers/sobol.cl\"\n"}};

FilmSettings settings_of(const std::string &filter, float radius) {
    FilmSettings film;
    film.width = width, film.height = height, film.spp = spp;
    film.filter = filter_number(filter), film.filter_radius = radius, film.splat = true;
    return film;
}

/// Samples `first` ... of some pixels, of random values, some too bright.
struct Part {
    std::vector<uint> pixels;
    uint first, samples;
    std::vector<Sample> values;

    BatchParams params() const {
        return {.pixels = uint(pixels.size()), .first_sample = first, .samples = samples, .spp = spp, .seed = 5, .position = PIXEL_CENTER};
    }
};

Part random_part(const std::vector<uint> &pixels, uint first, uint samples) {
    std::mt19937_64 random(first + 1);
    Part part{pixels, first, samples, {}};
    for (std::size_t i = 0; i < pixels.size() * samples; ++i) {
        Sample sample;
        for (Integer128 &channel : sample.sum) {
            const std::int64_t value = static_cast<std::int64_t>(random()) >> (14 + random() % 40);
            channel = {static_cast<std::uint64_t>(value), static_cast<std::uint64_t>(value >> 63)};
        }
        part.values.push_back(sample);
    }
    return part;
}

std::vector<uint> all_pixels() {
    std::vector<uint> pixels;
    for (uint y = 0; y < height; ++y)
        for (uint x = 0; x < width; ++x) pixels.push_back(x | y << 16);
    return pixels;
}

void add(Film &film, Splats &splats, const Part &part) {
    Device &device = test_device();
    const Buffer<uint> pixels(device, part.pixels);
    const std::vector<uint> outside;
    const Buffer<MotionPart> at_rest(device, 0);
    const Batch batch{.params = part.params(), .pixels = pixels, .camera = {}, .shutter = {}, .camera_motion = at_rest, .interior = outside};
    splats.weigh(batch);
    film.add(batch, Buffer<Sample>(device, part.values), &splats);
}

std::vector<vec2> places_of(const Part &part) {
    std::vector<uint> pixels, samples;
    for (const uint pixel : part.pixels)
        for (uint j = 0; j < part.samples; ++j) pixels.push_back(pixel), samples.push_back(part.first + j);
    return Probe(R"(#include "kernels/samplers/sobol.cl"
        kernel void probe(const global uint *pixels, const global uint *samples, const global BatchParams *batch, global vec2 *places) {
            places[get_global_id(0)] = sampler_pixel_position(pixels[get_global_id(0)], samples[get_global_id(0)], *batch);
        })")
        .run<vec2>(pixels, samples, part.params());
}

/// What a pixel should hold, in double.
struct Expected {
    std::array<std::array<double, 3>, 2> sums{}, squares{};
    std::array<double, 2> weights{}, squared_weights{};
    std::array<uint, 2> own{};
};

void add(std::vector<Expected> &film, const Part &part, const std::string &filter, double radius, uint &cut) {
    const std::vector<vec2> places = places_of(part);
    const auto f = [&](double x) { return filter_value(filter, x, radius) / filter_value(filter, 0, radius); };
    for (std::size_t s = 0; s < places.size(); ++s) {
        const uint px = part.pixels[s / part.samples] & 0xffff, py = part.pixels[s / part.samples] >> 16, half = (part.first + s % part.samples) % 2;
        ++film[py * width + px].own[half];
        std::array<double, 3> values;
        bool is_cut = false;
        for (std::size_t c = 0; c < 3; ++c) {
            const double value = double(value_of(part.values[s].sum[c])) * 0x1p-32;
            values[c] = std::clamp(value, -65536.0, 65536.0), is_cut |= values[c] != value;
        }
        cut += is_cut;
        for (uint y = 0; y < height; ++y)
            for (uint x = 0; x < width; ++x) {
                const double weight = f(px + double(places[s].x) - x - 0.5) * f(py + double(places[s].y) - y - 0.5);
                Expected &pixel = film[y * width + x];
                pixel.weights[half] += weight, pixel.squared_weights[half] += weight * weight;
                for (std::size_t c = 0; c < 3; ++c)
                    pixel.sums[half][c] += weight * values[c], pixel.squares[half][c] += weight * values[c] * values[c];
            }
    }
}

void expect_near(const Film &film, const std::vector<Expected> &expected) {
    const std::vector<FilmPixel> pixels = film.read();
    const std::vector<PixelWeights> weights = film.read_weights();
    // Tables are linear between nodes: f'' / 8 times the square of 1/2048 of the radius, and rounded.
    constexpr double off = 3e-6;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        for (const uint half : {0u, 1u}) {
            SCOPED_TRACE(testing::Message() << "pixel " << i << ", half " << half);
            ASSERT_EQ(pixels[i].counts[half], expected[i].own[half]);
            ASSERT_NEAR(double(weights[i].sums[half]) * 0x1p-30, expected[i].weights[half], off * spp);
            ASSERT_NEAR(double(weights[i].squares[half]) * 0x1p-30, expected[i].squared_weights[half], off * spp);
            for (std::size_t c = 0; c < 3; ++c) {
                ASSERT_NEAR(double(value_of(pixels[i].sums[half][c])) * 0x1p-32, expected[i].sums[half][c], off * 9 * spp * 65536);
                ASSERT_NEAR(double(value_of(pixels[i].squares[half][c])) * 0x1p-64, expected[i].squares[half][c], off * 9 * spp * 0x1p32);
            }
        }
}

class SplatsOf : public testing::TestWithParam<std::pair<const char *, float>> {};

/// In batches that end anywhere, in bands of any number of rows.
TEST_P(SplatsOf, CountInAllPixelsByTheirDistance) {
    const auto &[filter, radius] = GetParam();
    const FilmSettings settings = settings_of(filter, radius);
    const std::vector<uint> all = all_pixels(), some(all.begin(), all.begin() + 30), others(all.begin() + 30, all.end());
    const std::vector<Part> parts = {random_part(all, 0, 5), random_part(some, 5, 19), random_part(others, 5, 19)};
    std::vector<Expected> expected(width * height);
    uint cut = 0;
    for (const Part &part : parts) add(expected, part, filter, radius, cut);
    EXPECT_GT(cut, 0u) << "the test shows nothing";
    std::vector<vec3> picture;
    for (const std::size_t rows : {1u, 3u, 100u}) {
        Splats splats(test_device(), settings, lists, 4096);
        Film film(test_device(), settings, rows * width * sizeof(FilmPixel));
        for (const Part &part : parts) add(film, splats, part);
        expect_near(film, expected);
        EXPECT_EQ(film.clamped(), cut);
        if (picture.empty()) picture = film.develop();
        EXPECT_EQ(film.develop(), picture);
    }
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const Expected &pixel = expected[i];
        const double mean = (pixel.sums[0][0] + pixel.sums[1][0]) / (pixel.weights[0] + pixel.weights[1]);
        ASSERT_NEAR(double(picture[i].x), mean, 1e-5 * (1000 + std::abs(mean))) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Kernels, SplatsOf,
                         testing::Values(std::pair{"tent", 1.0f}, std::pair{"gaussian", 1.5f}, std::pair{"blackman_harris", 1.5f},
                                         std::pair{"tent", 2.3f}, std::pair{"gaussian", 0.5f}),
                         [](const auto &info) { return std::string(info.param.first) + std::to_string(int(info.param.second * 10)); });

/// As many bright samples of a pixel as 64 bits could not hold the sums of, in one batch and in two.
TEST(Splats, OfMoreSamplesThanAreTakenAtOnceAreTheSameInParts) {
    FilmSettings settings = settings_of("tent", 1);
    settings.spp = 70000;
    const std::vector<uint> pixel = {3 | 2 << 16};
    Part whole{pixel, 0, settings.spp, std::vector<Sample>(settings.spp)};
    for (std::size_t i = 0; i < whole.values.size(); ++i) whole.values[i].sum[i % 3] = {std::uint64_t{65536 - i % 7} << 32, 0};
    const auto middle = whole.values.begin() + 34567;
    const Part first{pixel, 0, 34567, {whole.values.begin(), middle}}, second{pixel, 34567, settings.spp - 34567, {middle, whole.values.end()}};
    Splats splats(test_device(), settings, lists, settings.spp);
    Film at_once(test_device(), settings), in_parts(test_device(), settings);
    add(at_once, splats, whole);
    for (const Part *part : {&first, &second}) add(in_parts, splats, *part);
    EXPECT_EQ(at_once.develop(), in_parts.develop());
    const std::vector<FilmPixel> one = at_once.read(), other = in_parts.read();
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
        for (const uint half : {0u, 1u}) {
            EXPECT_EQ(one[i].counts[half], other[i].counts[half]);
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_EQ(value_of(one[i].sums[half][c]), value_of(other[i].sums[half][c]));
                EXPECT_EQ(value_of(one[i].squares[half][c]), value_of(other[i].squares[half][c]));
                sum += double(value_of(one[i].sums[half][c])) * 0x1p-32;
                squares += double(value_of(one[i].squares[half][c])) * 0x1p-64;
            }
        }
    // Weights of a tent of radius 1 in all pixels are 1 together, and values 65530 to 65536.
    EXPECT_NEAR(sum, settings.spp * 65533.0, settings.spp * 0.01);
    EXPECT_NEAR(squares, settings.spp * (65533.0 * 65533.0 + 4), settings.spp * 65533.0 * 0.02);
}

/// Of samples of one value, to the last bit: what they weigh together times the value is that of their sum.
TEST(Splats, SquaresAreExactProducts) {
    const FilmSettings settings = settings_of("gaussian", 1.5);
    std::mt19937_64 random(7);
    std::vector<std::int64_t> values = {1, (1 << 24) - 1, 1 << 24, std::int64_t{1} << 47, std::int64_t{1} << 48};
    for (uint i = 0; i < 40; ++i) values.push_back(static_cast<std::int64_t>(random() >> (16 + i)));
    Splats splats(test_device(), settings, lists, 16);
    for (const std::int64_t positive : values)
        for (const std::int64_t value : {positive, -positive}) {
            const Integer128 channel = {static_cast<std::uint64_t>(value), static_cast<std::uint64_t>(value >> 63)};
            Film film(test_device(), settings);
            add(film, splats, {{3 | 2 << 16}, 0, 5, std::vector<Sample>(5, {{channel, channel, channel}})});
            __int128 sum = 0;
            for (const FilmPixel &pixel : film.read())
                for (const uint half : {0u, 1u})
                    for (std::size_t c = 0; c < 3; ++c) {
                        ASSERT_TRUE(value_of(pixel.squares[half][c]) == value_of(pixel.sums[half][c]) * value) << value << ", channel " << c;
                        sum += value_of(pixel.sums[half][c]);
                    }
            ASSERT_TRUE(sum != 0 || std::abs(value) == 1) << "the test shows nothing of " << value;
        }
}

/// Of samples of one weight nothing changes; of others the mean's variance is that of their values times Σw² / (Σw)².
TEST(PixelHalvesOfSplats, AreThoseOfWeightedMeans) {
    const auto wide = [](double x) { return Integer128{static_cast<std::uint64_t>(x), 0}; };
    FilmPixel plain{}, pixel{};
    PixelWeights weights{};
    const double values[] = {1, 2, 4, 8}, ws[] = {0.5, 0.25, 1, 0.75};
    double w = 0, w2 = 0, wv = 0, wv2 = 0;
    for (int i = 0; i < 4; ++i) w += ws[i], w2 += ws[i] * ws[i], wv += ws[i] * values[i], wv2 += ws[i] * values[i] * values[i];
    for (const uint half : {0u, 1u}) {
        plain.counts[half] = pixel.counts[half] = 4;
        plain.sums[half][0] = wide(15 * 0x1p32), plain.squares[half][0] = {0, 85};
    }
    weights.sums[0] = weights.sums[1] = std::uint64_t{4} << 30, weights.squares[0] = weights.squares[1] = std::uint64_t{4} << 30;
    const PixelHalves same(plain, weights), before(plain);
    EXPECT_DOUBLE_EQ(same.means[0][0], before.means[0][0]);
    EXPECT_NEAR(same.variances[0][0], before.variances[0][0], 1e-12);
    for (const uint half : {0u, 1u}) {
        pixel.sums[half][0] = wide(wv * 0x1p32), pixel.squares[half][0] = {0, std::uint64_t(wv2 * 4) / 4};
        weights.sums[half] = std::uint64_t(w * 0x1p30), weights.squares[half] = std::uint64_t(w2 * 0x1p30);
    }
    const PixelHalves halves(pixel, weights);
    const double n = w * w / w2, mean = wv / w, whole_squares = std::floor(wv2);
    EXPECT_NEAR(halves.means[1][0], mean, 1e-9);
    EXPECT_NEAR(halves.counts[1], n, 1e-9);
    EXPECT_NEAR(halves.variances[1][0], (whole_squares / w - mean * mean) / (n - 1), 1e-9);
    EXPECT_DOUBLE_EQ(halves.share(0), 0.5);
}

}  // namespace
}  // namespace brandung
