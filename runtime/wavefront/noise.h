/// Noise: how far a picture is from what more and more samples would make of it, estimated from its own film.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "runtime/wavefront/pixel_halves.h"

namespace brandung {

/// The error of a picture by chance. What makes it wrong beyond that is not in it: see Integrator::biases().
struct Noise {
    double relmse;     ///< estimate of the mean over pixels and channels of (value - limit)² / (limit² + 0.01)
    double low, high;  ///< ends of an interval that holds the error of this very picture with a probability of 95 %, but see NoiseSums::noise()
};

/// Sums over pixels, weighed by w, of means over channels; the names are those of NoiseSums.
struct NoiseTerms {
    void add(const NoiseTerms &other);
    /// `correlated_pixels`: where pixels share samples, by how many the degrees of freedom are fewer.
    std::optional<Noise> noise(double correlated_pixels) const;

    std::size_t pixels = 0, unknown = 0;                         ///< all, and those with fewer than two samples
    double halves = 0, squares = 0, crossed = 0, curvature = 0;  ///< of D², S, X and Y
    double halves_squared = 0, squares_squared = 0;              ///< of (D²)² and S²
    double mixed_squared = 0;                                    ///< of X², as far as it is of mixtures
    double few = 0, few_squared = 0;                             ///< of D² and (D²)² where there are no four samples
};

/// Sums over a picture's pixels from which Noise follows.
///
/// The means A and B of the two halves are independent estimates of a pixel's value μ, so D² = (A - B)² / 4 estimates the squared error M² of their
/// mean without bias, however the samples of a half are stratified. The two differ by M² - D² = (A - μ)(B - μ), whose variance is exactly 4 V², V
/// being the variance of the mean. Where A and B are normal, M² and D² are independent and distributed alike, and the sums over k pixels of the same
/// V have the ratio of an F-distribution of k and k degrees of freedom. So has any picture, with k = (Σ V)² / Σ V² (Satterthwaite 1946): this is the
/// interval. V² comes from the variances S_A and S_B of the halves' means, from squares within the halves: these are independent too, and
/// S² = S_A S_B / 4 has the mean V² whatever the samples' kurtosis. S = (S_A + S_B) / 4 of stratified samples is too great; the sums over the
/// picture give g = Σ D² / Σ S, by which it is multiplied.
///
/// The weights w = 1 / (μ² + 0.01) of relMSE are unknown too, and where samples are skewed the picture's own values depend on D². But the variance
/// of one half and the value of the other do not: the sum X of S_A w(B) / 4 + S_B w(A) / 4 is too large only by the curvature of w,
/// Y = S_A S_B (w''(A) + w''(B)) / 8, and g (X - g Y) is the estimate.
///
/// The curvature says nothing where few samples are far apart: of a pixel on the edge of a lamp one half may have seen nothing, and w(B) is a
/// hundred times too large. There the eight pixels about it, which show the lamp and what is dark, say between which values the pixel's may be, and
/// where A's samples are of these two ends, and w is open between them, the weight is that of a Mixture. What is unlike all around it, a rare
/// outlier, is not taken for an edge.
class NoiseSums {
public:
    /// `width` of the picture [pixels]; `correlated_pixels` as of its filter.
    explicit NoiseSums(std::size_t width, double correlated_pixels = 1) : width_(width), correlated_pixels_(correlated_pixels) {}
    /// The picture's next rows, from the top; with their weights where samples count in several pixels.
    void add_rows(std::span<const FilmPixel> rows, std::span<const PixelWeights> weights = {});
    /// Of the rows so far; nothing where a pixel had fewer than two samples: what is known of the others is not the picture's. Of fewer than four
    /// samples the estimate is rough, since S is unknown, and the interval begins at 0. Of a handful of pixels, or of four samples of a few pixels
    /// that make nearly all of the error, the interval holds the error more seldom: of one pixel's, in 70 to 80 %.
    std::optional<Noise> noise() const;

private:
    std::size_t width_;
    double correlated_pixels_;
    std::vector<PixelHalves> rows_;  ///< the last one or two: the last one's lower neighbours are still to come
    NoiseTerms terms_;               ///< of all rows before the last
};

}  // namespace brandung
