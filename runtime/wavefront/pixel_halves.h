/// What the film's exact sums say of a pixel: means of its halves of samples, and errors of these means.
#pragma once
#include "kernels/core/items.h"

namespace brandung {

/// A pixel's two halves of samples: their means, and what their samples say of these means' variances, per channel.
struct PixelHalves {
    explicit PixelHalves(const FilmPixel &pixel);
    /// Of samples that count in several pixels.
    PixelHalves(const FilmPixel &pixel, const PixelWeights &weights);

    /// Only where there are two samples or more.
    double share(std::size_t half) const { return weights[half] / (weights[0] + weights[1]); }
    /// In either half one that weighs anything.
    bool has_two_samples() const { return samples[0] > 0 && samples[1] > 0 && weights[0] > 0 && weights[1] > 0; }
    bool has_variances() const { return samples[0] > 1 && samples[1] > 1 && counts[0] > 1 && counts[1] > 1; }
    double mean(std::size_t c) const { return share(0) * means[0][c] + share(1) * means[1][c]; }
    double squared_error_by_halves(std::size_t c) const;                      ///< D² of NoiseSums
    double squared_error_by_squares(std::size_t half, std::size_t c) const {  ///< S_A / 4 or S_B / 4 of NoiseSums
        return share(half) * share(half) * variances[half][c];
    }

    uint samples[2];    ///< of the pixel's own
    double weights[2];  ///< of all that count in it
    double counts[2];   ///< of samples of one weight whose mean would be as certain: the square of all weights over the sum of their squares
    double means[2][3];
    double variances[2][3];  ///< 0 where one sample leaves it unknown
};

/// Standard error of each channel of a pixel's value, from the squares of its samples, if there are four: too large where these are stratified.
/// Infinite below two samples, of which it is not known.
vec3 standard_error(const PixelHalves &pixel);

}  // namespace brandung
