#include "runtime/wavefront/pixel_halves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/filters/splat.h"

namespace brandung {
namespace {

constexpr double unit = 0x1p-32;  ///< of sums; their squares' is its square
constexpr long double weight_unit = 1.0L / SPLAT_UNIT;

long double value_of(Integer128 x) { return static_cast<long double>(static_cast<std::int64_t>(x.high)) * 0x1p64L + x.low; }

}  // namespace

PixelHalves::PixelHalves(const FilmPixel &pixel) {
    for (const std::size_t half : {0, 1}) {
        const long double n = weights[half] = counts[half] = samples[half] = pixel.counts[half];
        for (std::size_t c = 0; c < 3; ++c) {
            const long double sum = value_of(pixel.sums[half][c]), squares = value_of(pixel.squares[half][c]);
            means[half][c] = n < 1 ? 0 : static_cast<double>(sum / n * unit);
            variances[half][c] = n < 2 ? 0 : static_cast<double>(std::max((squares - sum * sum / n) / ((n - 1) * n) * (unit * unit), 0.0L));
        }
    }
}

PixelHalves::PixelHalves(const FilmPixel &pixel, const PixelWeights &of) {
    for (const std::size_t half : {0, 1}) {
        const long double weight = of.sums[half] * weight_unit, squared_weight = of.squares[half] * weight_unit;
        const long double n = squared_weight > 0 ? weight * weight / squared_weight : 0;
        samples[half] = pixel.counts[half], weights[half] = static_cast<double>(weight), counts[half] = static_cast<double>(n);
        for (std::size_t c = 0; c < 3; ++c) {
            const long double mean = n > 0 ? value_of(pixel.sums[half][c]) * unit / weight : 0;
            const long double square = n > 0 ? value_of(pixel.squares[half][c]) * (unit * unit) / weight : 0;
            means[half][c] = static_cast<double>(mean);
            variances[half][c] = n > 1 ? static_cast<double>(std::max((square - mean * mean) / (n - 1), 0.0L)) : 0;
        }
    }
}

double PixelHalves::squared_error_by_halves(std::size_t c) const {
    const double difference = means[0][c] - means[1][c];
    return difference * difference * share(0) * share(1);
}

vec3 standard_error(const PixelHalves &pixel) {
    if (!pixel.has_two_samples()) return vec3(std::numeric_limits<float>::infinity());
    const auto error = [&](std::size_t c) {
        const double by_squares = pixel.squared_error_by_squares(0, c) + pixel.squared_error_by_squares(1, c);
        return static_cast<float>(std::sqrt(pixel.has_variances() ? by_squares : pixel.squared_error_by_halves(c)));
    };
    return {error(0), error(1), error(2)};
}

}  // namespace brandung
