#include "runtime/wavefront/noise.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

namespace brandung {
namespace {

constexpr double unit = 0x1p-32;             ///< of sums; their squares' is its square
constexpr double darkest = 0.01;             ///< relMSE's weights are 1 / (limit² + this)
constexpr double two_sided_95 = 1.95996398;  ///< standard deviations

long double value_of(Integer128 x) { return static_cast<long double>(static_cast<std::int64_t>(x.high)) * 0x1p64L + x.low; }

/// Mean of the samples of one half of a pixel, in one channel, and the variance of that mean: 0 where one sample leaves it unknown.
struct Half {
    long double count, mean, variance;
};

Half half_of(const FilmPixel &pixel, std::size_t half, std::size_t c) {
    const long double n = pixel.counts[half], sum = value_of(pixel.sums[half][c]), squares = value_of(pixel.squares[half][c]);
    return {n, sum / n * unit, n < 2 ? 0 : std::max((squares - sum * sum / n) / ((n - 1) * n) * (unit * unit), 0.0L)};
}

/// w(x) = 1 / (x² + 0.01), and half its second derivative.
struct Weight {
    explicit Weight(double x) : w(1 / (x * x + darkest)), half_curvature(w * w * (4 * x * x * w - 1)) {}
    double w, half_curvature;
};

/// Of one channel of a pixel that has two samples or more; D², S, X and Y of NoiseSums.
struct Channel {
    Channel(const Half &a, const Half &b) {
        const long double n = a.count + b.count, a_share = a.count / n, b_share = b.count / n, difference = a.mean - b.mean;
        weight = Weight(static_cast<double>(a_share * a.mean + b_share * b.mean));
        halves = static_cast<double>(difference * difference * a_share * b_share);
        const double of_a = static_cast<double>(a_share * a_share * a.variance), of_b = static_cast<double>(b_share * b_share * b.variance);
        const Weight at_a(static_cast<double>(a.mean)), at_b(static_cast<double>(b.mean));
        squares = of_a + of_b;
        crossed = of_a * at_b.w + of_b * at_a.w;
        curvature = of_a * at_b.half_curvature * static_cast<double>(b.variance) + of_b * at_a.half_curvature * static_cast<double>(a.variance);
    }
    Weight weight{0};
    double halves, squares, crossed, curvature;
};

bool has_two_samples(const FilmPixel &pixel) { return pixel.counts[0] > 0 && pixel.counts[1] > 0; }
bool has_variances(const FilmPixel &pixel) { return pixel.counts[0] > 1 && pixel.counts[1] > 1; }

/// `value` less `correction`, which is much smaller unless there is too much noise to tell; never below 0.
double corrected(double value, double correction) { return correction > 0 && value > 0 ? value / (1 + correction / value) : value - correction; }

}  // namespace

void NoiseSums::add_pixel(const FilmPixel &pixel) {
    if (!has_two_samples(pixel)) return;
    double halves = 0, squares = 0, curvature = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const Channel channel(half_of(pixel, 0, c), half_of(pixel, 1, c));
        halves += channel.halves * channel.weight.w / 3, squares += channel.squares * channel.weight.w / 3;
        crossed_ += channel.crossed / 3, curvature_ += channel.curvature / 3;
        curvature += channel.halves * channel.halves * channel.weight.half_curvature / 9;
    }
    ++pixels_;
    if (!has_variances(pixel)) {
        few_ += corrected(halves, curvature);
        fourth_of_few_ += halves * halves / 2;
        return;
    }
    const double n = static_cast<double>(pixel.counts[0]) + pixel.counts[1], factor = (n - 2) / (2 * (n - 3));
    halves_ += halves, squares_ += squares;
    halves_squared_ += halves * halves;
    fourth_of_halves_ += factor * halves * halves, fourth_of_squares_ += factor * squares * squares;
}

void NoiseSums::add(std::span<const FilmPixel> pixels) {
    using Range = tbb::blocked_range<std::size_t>;
    const auto sum = [&](const Range &range, NoiseSums sums) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) sums.add_pixel(pixels[i]);
        return sums;
    };
    const auto join = [](NoiseSums a, const NoiseSums &b) {
        a.add(b);
        return a;
    };
    add(tbb::parallel_deterministic_reduce(Range(0, pixels.size(), 4096), NoiseSums(), sum, join));
}

void NoiseSums::add(const NoiseSums &other) {
    pixels_ += other.pixels_;
    halves_ += other.halves_, squares_ += other.squares_, crossed_ += other.crossed_, curvature_ += other.curvature_;
    halves_squared_ += other.halves_squared_;
    fourth_of_halves_ += other.fourth_of_halves_, fourth_of_squares_ += other.fourth_of_squares_;
    few_ += other.few_, fourth_of_few_ += other.fourth_of_few_;
}

std::optional<Noise> NoiseSums::noise() const {
    if (pixels_ == 0) return std::nullopt;
    const double pixels = static_cast<double>(pixels_), gain = squares_ > 0 ? halves_ / squares_ : 0;
    // The squares of stratified samples say little of the kurtosis of D, to which few strata contribute: it is 2.4 for one in either half, in which
    // a sample may see either of two values (1.2 less than 3 on average, for two of them), and comes to 3 with many. In any case it is at least 2,
    // and where it seems above 16 the few samples that make it so are not to be trusted.
    const double independent = std::min(gain, 1.0), by_squares = fourth_of_halves_ - gain * gain * fourth_of_squares_;
    const double variances_squared =
        std::clamp(independent * by_squares + (1 - independent) * halves_squared_ / 2.5, halves_squared_ / 16, halves_squared_ / 2);
    const double plain = gain * squares_, unbiased = gain * corrected(crossed_, gain * curvature_);
    // The correction has an error of its own order squared, which counts only where noise is strong.
    const double doubtful = plain > 0 ? 2 * (unbiased - plain) * (unbiased - plain) / plain : 0;
    return Noise{(unbiased + few_) / pixels, (two_sided_95 * 2 * std::sqrt(variances_squared + fourth_of_few_) + doubtful + few_) / pixels};
}

vec3 standard_error(const FilmPixel &pixel) {
    if (!has_two_samples(pixel)) return vec3(0);
    const auto error = [&](std::size_t c) {
        const Channel channel(half_of(pixel, 0, c), half_of(pixel, 1, c));
        return static_cast<float>(std::sqrt(has_variances(pixel) ? channel.squares : channel.halves));
    };
    return {error(0), error(1), error(2)};
}

}  // namespace brandung
