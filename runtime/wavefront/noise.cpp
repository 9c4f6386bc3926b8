#include "runtime/wavefront/noise.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>

#include "runtime/wavefront/relmse_weight.h"

namespace brandung {
namespace {

/// What a variable of the F-distribution of `k` and `k` degrees of freedom exceeds with a probability of 2.5 %, and its inverse falls below with the
/// same: x / (1 - x), where x is this quantile of Beta(k/2, k/2).
double upper_ratio(double k) {
    double above;
    const double x = boost::math::ibeta_inv(k / 2, k / 2, 0.975, &above);
    return x / above;
}

/// `value` less `correction`, which is much smaller unless there is too much noise to tell; never below 0.
double corrected(double value, double correction) { return correction > 0 && value > 0 ? value / (1 + correction / value) : value - correction; }

/// A pixel of a picture's rows, and the up to eight about it.
class Neighbourhood {
public:
    Neighbourhood(std::span<const PixelHalves> rows, std::size_t width, std::size_t index) : pixel(rows[index]) {
        const std::size_t x = index % width, y = index / width, left = x > 0 ? x - 1 : 0, right = std::min(x + 1, width - 1);
        for (std::size_t row = y > 0 ? y - 1 : 0; row <= std::min(y + 1, rows.size() / width - 1); ++row)
            for (std::size_t column = left; column <= right; ++column) all_[count_++] = &rows[row * width + column];
    }
    /// Of the means of a half, in one channel.
    ValueRange range(std::size_t half, std::size_t c) const {
        ValueRange range{std::abs(pixel.means[half][c]), std::abs(pixel.means[half][c])};
        for (const PixelHalves *near : std::span(all_).first(count_))
            if (near->counts[half] > 0) range.include(near->means[half][c]);
        return range;
    }

    const PixelHalves &pixel;

private:
    std::array<const PixelHalves *, 9> all_;
    std::size_t count_ = 0;
};

/// What one channel of a pixel adds to the terms of NoiseSums.
struct ChannelTerms {
    double halves = 0, crossed = 0, curvature = 0, mixed = 0;
    std::array<double, 2> squares{};  ///< of each half: S_A / 4 and S_B / 4
};

/// S_A w(B) / 4 and its curvature, A being `half`; `squares`: S_A / 4.
void add_crossed(const Neighbourhood &pixels, std::size_t half, std::size_t c, double squares, ChannelTerms &terms) {
    if (squares == 0) return;
    const PixelHalves &pixel = pixels.pixel;
    const std::size_t other = 1 - half;
    const double mean = pixel.means[other][c];
    const Mixture mixture{pixels.range(other, c), std::abs(mean), pixel.counts[other]};
    if (mixture.is_open() &&
        Mixture::is_of_ends(mixture.range, std::abs(pixel.means[half][c]), pixel.variances[half][c] * (pixel.counts[half] - 1))) {
        const double mixed = squares * mixture.weight();
        terms.crossed += mixed, terms.mixed += mixed;
        return;
    }
    const RelmseWeight weight(mean);
    terms.crossed += squares * weight.w, terms.curvature += squares * weight.half_curvature * pixel.variances[other][c];
}

/// Of a pixel that has two samples or more in either half.
ChannelTerms channel_terms(const Neighbourhood &pixels, std::size_t c) {
    const PixelHalves &pixel = pixels.pixel;
    const RelmseWeight weight(pixel.mean(c));
    ChannelTerms terms{.halves = pixel.squared_error_by_halves(c) * weight.w};
    for (const std::size_t half : {0, 1}) {
        const double squares = pixel.squared_error_by_squares(half, c);
        terms.squares[half] = squares * weight.w;
        add_crossed(pixels, half, c, squares, terms);
    }
    return terms;
}

/// D² of a pixel that has not, weighed; where nothing is known of its samples' distribution, its mean says nothing of the shares of a mixture.
double few_terms(const Neighbourhood &pixels, std::size_t c) {
    const double squared = pixels.pixel.squared_error_by_halves(c);
    if (squared == 0) return 0;
    ValueRange range = pixels.range(0, c);
    const ValueRange of_other_half = pixels.range(1, c);
    range.include(of_other_half.low), range.include(of_other_half.high);
    const Mixture mixture{range, range.low, 0};
    if (mixture.is_open()) return squared * mixture.weight();
    const RelmseWeight weight(pixels.pixel.mean(c));
    return corrected(squared * weight.w, squared * squared / 3 * weight.half_curvature);  // E D⁴ = 3 V²
}

void add_pixel(const Neighbourhood &pixels, NoiseTerms &sums) {
    const PixelHalves &pixel = pixels.pixel;
    ++sums.pixels;
    if (!pixel.has_two_samples()) {
        ++sums.unknown;
        return;
    }
    if (!pixel.has_variances()) {
        const double few = (few_terms(pixels, 0) + few_terms(pixels, 1) + few_terms(pixels, 2)) / 3;
        sums.few += few, sums.few_squared += few * few;
        return;
    }
    ChannelTerms mean{};
    for (std::size_t c = 0; c < 3; ++c) {
        const ChannelTerms terms = channel_terms(pixels, c);
        mean.halves += terms.halves / 3, mean.squares[0] += terms.squares[0] / 3, mean.squares[1] += terms.squares[1] / 3;
        mean.crossed += terms.crossed / 3, mean.curvature += terms.curvature / 3, mean.mixed += terms.mixed / 3;
    }
    sums.halves += mean.halves, sums.squares += mean.squares[0] + mean.squares[1], sums.crossed += mean.crossed, sums.curvature += mean.curvature;
    sums.halves_squared += mean.halves * mean.halves;
    sums.squares_squared += mean.squares[0] * mean.squares[1] / (pixel.share(0) * pixel.share(1));
    sums.mixed_squared += mean.mixed * mean.mixed;
}

/// Of all rows of `rows` from the `first`-th to before the `last`-th; in parallel, the same bits each time.
NoiseTerms terms_of(std::span<const PixelHalves> rows, std::size_t width, std::size_t first, std::size_t last) {
    using Range = tbb::blocked_range<std::size_t>;
    const auto sum = [&](const Range &range, NoiseTerms terms) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) add_pixel(Neighbourhood(rows, width, i), terms);
        return terms;
    };
    const auto join = [](NoiseTerms a, const NoiseTerms &b) {
        a.add(b);
        return a;
    };
    return tbb::parallel_deterministic_reduce(Range(first * width, last * width, 1024), NoiseTerms(), sum, join);
}

}  // namespace

void NoiseTerms::add(const NoiseTerms &other) {
    pixels += other.pixels, unknown += other.unknown;
    halves += other.halves, squares += other.squares, crossed += other.crossed, curvature += other.curvature;
    halves_squared += other.halves_squared, squares_squared += other.squares_squared, mixed_squared += other.mixed_squared;
    few += other.few, few_squared += other.few_squared;
}

std::optional<Noise> NoiseTerms::noise(double correlated_pixels) const {
    if (pixels == 0 || unknown > 0) return std::nullopt;
    const double gain = squares > 0 ? halves / squares : 0;
    // The variances of stratified samples say little of that of D: they are too great by another factor in every pixel. But E D⁴ / V² is known well
    // enough: it is 3 where many strata contribute. Where only one stratum of either half does, and a sample there is of one of two values, of one
    // with the probability p, it is E D⁴ = p (1 - p) / 8 and V² = (p (1 - p) / 2)² for values that differ by 1, and 2.5 over all p: (1/6/8) /
    // (1/30/4). Where it is 3, intervals are too wide by 10 %.
    const double independent = std::min(gain * gain, 1.0);
    const double variances_squared = independent * gain * gain * squares_squared + (1 - independent) * halves_squared / 2.5;
    const double plain = gain * squares, unbiased = gain * corrected(crossed, gain * curvature), change = std::abs(unbiased - plain);
    // Where weights make much of a difference they are doubtful themselves: by an error of their change's own order squared, but not beyond it.
    const double doubtful = (plain > 0 ? std::min(change * change / plain, change) : 0) + few, count = static_cast<double>(pixels);
    // What mixtures weigh is open by about as much as they add.
    const double sum = unbiased + few, sum_of_squares = variances_squared + gain * gain * mixed_squared + few_squared;
    const double ratio = sum > 0 ? upper_ratio(std::clamp(sum * sum / (correlated_pixels * sum_of_squares), 1.0, count)) : 1;
    return Noise{sum / count, std::max(sum / ratio - doubtful, 0.0) / count, (sum * ratio + doubtful) / count};
}

void NoiseSums::add_rows(std::span<const FilmPixel> rows, std::span<const PixelWeights> weights) {
    const std::size_t known = rows_.size();
    rows_.insert(rows_.end(), rows.size(), PixelHalves(FilmPixel{}));
    tbb::parallel_for(std::size_t{0}, rows.size(),
                      [&](std::size_t i) { rows_[known + i] = weights.empty() ? PixelHalves(rows[i]) : PixelHalves(rows[i], weights[i]); });
    const std::size_t count = rows_.size() / width_, first = known / width_ > 1 ? 1 : 0;
    if (count < 2) return;
    terms_.add(terms_of(rows_, width_, first, count - 1));
    rows_.erase(rows_.begin(), rows_.end() - static_cast<std::ptrdiff_t>(2 * width_));
}

std::optional<Noise> NoiseSums::noise() const {
    NoiseTerms all = terms_;
    if (!rows_.empty()) all.add(terms_of(rows_, width_, rows_.size() / width_ - 1, rows_.size() / width_));
    return all.noise(correlated_pixels_);
}

}  // namespace brandung
