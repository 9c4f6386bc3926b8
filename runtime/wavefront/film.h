/// Film: the picture as exact sums in fixed point.
#pragma once
#include <limits>

#include "runtime/opencl/kernel.h"
#include "runtime/wavefront/batch.h"

namespace brandung {

class Film {
public:
    /// Black. Bands of rows are allocations of their own, none larger than `largest_band` [bytes], unless one row is, or than the device allows.
    /// Throws Error, with the sizes, if the device's memory is too small, and BuildError.
    Film(Device &device, uint width, uint height, std::size_t largest_band = std::numeric_limits<std::size_t>::max());

    /// Adds a batch's samples.
    void add(const Batch &batch, const Buffer<Sample> &samples);
    /// Mean radiance, 3 floats per pixel, row by row from the top; black where there is no sample yet.
    std::vector<vec3> develop();
    /// Exact sums, row by row from the top.
    std::vector<FilmPixel> read() const;
    /// Samples that were cut at ±2^16.
    uint clamped() const { return clamped_.read().at(0); }

    uint width() const { return width_; }
    uint height() const { return height_; }
    std::size_t bytes() const;

private:
    struct Band {
        FilmBand params;
        Buffer<FilmPixel> pixels;
    };
    uint width_, height_;
    Kernel add_samples_, develop_;
    std::vector<Band> bands_;  ///< from the top
    Buffer<vec3> picture_;     ///< of one band
    Buffer<uint> clamped_;
};

}  // namespace brandung
