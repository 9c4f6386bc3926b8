/// Noise: how far a picture is from what more and more samples would make of it, estimated from its own film.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "kernels/core/items.h"

namespace brandung {

/// The error of a picture by chance. What makes it wrong beyond that is not in it: see Integrator::biases().
struct Noise {
    double relmse;      ///< estimate of the mean over pixels and channels of (value - limit)² / (limit² + 0.01)
    double half_width;  ///< of an interval about it, which holds the error of this very picture with a probability of 95 %
    double low() const { return relmse > half_width ? relmse - half_width : 0; }
    double high() const { return relmse + half_width; }
};

/// Sums over pixels from which Noise follows; they can be added up part by part.
///
/// The means A and B of the two halves are independent estimates of a pixel's value μ, so D² = (A - B)² / 4 estimates the squared error M² of their
/// mean without bias, however the samples of a half are stratified. The two differ by M² - D² = (A - μ)(B - μ), whose variance is exactly 4 V², V
/// being the variance of the mean. Kurtosis κ makes E D⁴ = (3 + κ/n) V² useless for V² alone, but the variance S of the mean, from squares within
/// the halves, has E S² = (1 + 2/(n - 2) + κ/n) V² for independent samples, and so V² = E (D⁴ - S²) (n - 2) / (2 (n - 3)). Stratified samples have a
/// greater S, by a factor g that the sums of D² and S over the picture give.
///
/// The weights w = 1 / (μ² + 0.01) of relMSE are unknown too, and where samples are skewed the picture's own values depend on D². But the variance
/// of one half and the value of the other do not: the sum X of S_A w(B) / 4 + S_B w(A) / 4 is too large only by the curvature of w,
/// Y = S_A S_B (w''(A) + w''(B)) / 8, and g (X - g Y) is the estimate. It is too large where a pixel's samples are few and far apart, as on the edge
/// of a lamp, of which one half may have seen nothing: w is then that of the dark. That is the safe side: a lower bound on the means of halves, tried
/// instead, let pictures with a few outliers pass for seven times better than they are.
class NoiseSums {
public:
    /// Pixels with fewer than two samples are left out.
    void add(std::span<const FilmPixel> pixels);
    void add(const NoiseSums &other);
    /// Nothing where no pixel had two samples. Of fewer than four samples the estimate is rough, since S is unknown, and the interval
    /// begins at 0.
    std::optional<Noise> noise() const;

private:
    void add_pixel(const FilmPixel &pixel);

    // All weighed by w, and means over channels.
    std::size_t pixels_ = 0;
    double halves_ = 0, squares_ = 0, crossed_ = 0, curvature_ = 0;  ///< of D², S, X and Y
    double halves_squared_ = 0;                                      ///< of (D²)²
    double fourth_of_halves_ = 0, fourth_of_squares_ = 0;            ///< of (D²)² and S² times (n - 2) / (2 (n - 3))
    double few_ = 0, fourth_of_few_ = 0;  ///< of D² and (D²)² / 2 where there are no four samples: E D⁴ is at least 2 V²
};

/// Standard error of each channel of a pixel's value, from the squares of its samples, if there are four: too large where these are stratified.
/// 0 below two samples.
vec3 standard_error(const FilmPixel &pixel);

}  // namespace brandung
