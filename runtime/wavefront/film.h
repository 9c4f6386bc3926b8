/// Film: the picture as exact sums in fixed point.
#pragma once
#include <limits>

#include "runtime/opencl/kernel.h"
#include "runtime/wavefront/bands.h"
#include "runtime/wavefront/batch.h"
#include "runtime/wavefront/noise.h"
#include "runtime/wavefront/splats.h"

namespace brandung {

class Film {
public:
    /// Black. Bands of rows are allocations of their own, none larger than `largest_band` [bytes], unless one row is, or than the device allows.
    /// Throws Error, with the sizes, if the device's memory is too small, and BuildError.
    Film(Device &device, const Window &window, std::size_t largest_band = std::numeric_limits<std::size_t>::max());
    /// As the settings have it; of filters whose samples are splatted it has the weights too.
    Film(Device &device, const FilmSettings &settings, std::size_t largest_band = std::numeric_limits<std::size_t>::max());

    /// Makes it black again; what was cut is still counted.
    void clear();
    /// Adds a batch's samples: each to its pixel, or, if the film has weights, with these splats to all that the filter reaches in the window.
    void add(const Batch &batch, const Buffer<Sample> &samples, Splats *splats = nullptr);
    /// Mean radiance, 3 floats per pixel, row by row from the top; black where there is no sample yet.
    std::vector<vec3> develop();
    /// Exact sums, row by row from the top.
    std::vector<FilmPixel> read() const { return bands_.read(); }
    /// Of each pixel, if samples are splatted.
    std::vector<PixelWeights> read_weights() const { return splatted_ ? splatted_->weights.read() : std::vector<PixelWeights>(); }
    /// Of its samples so far; nothing where a pixel has fewer than two.
    std::optional<Noise> noise() const;
    /// Samples that were cut at ±2^16; of splatted ones also those beyond the window that were rendered for its pixels.
    uint clamped() const { return clamped_.read().at(0); }

    const Window &window() const { return window_; }
    std::size_t bytes() const { return picture_.bytes() + bands_.bytes() + (splatted_ ? splatted_->weights.bytes() : 0); }

private:
    /// What splats need beside.
    struct Splatted {
        Bands<PixelWeights> weights;  ///< of the same rows as the film's
        double correlated_pixels;
    };
    /// With the kernels of films of its kind, but without the weights of splatted ones.
    Film(Device &device, const Window &window, std::size_t largest_band, bool splats);

    Window window_;
    Kernel add_, develop_;
    Buffer<vec3> picture_;  ///< of one band
    Bands<FilmPixel> bands_;
    Buffer<uint> clamped_;
    std::optional<Splatted> splatted_;
};

}  // namespace brandung
