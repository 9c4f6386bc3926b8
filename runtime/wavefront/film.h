/// Film: the picture as exact sums in fixed point.
#pragma once
#include "runtime/opencl/kernel.h"
#include "runtime/wavefront/batch.h"

namespace brandung {

class Film {
public:
    /// Black. Throws Error if one allocation of the device cannot hold the sums of so many pixels, and BuildError.
    Film(Device &device, uint width, uint height);

    /// Adds a batch's samples.
    void add(const Batch &batch, const Buffer<Sample> &samples);
    /// Mean radiance, 3 floats per pixel, row by row from the top; black where there is no sample yet.
    std::vector<vec3> develop();
    /// Exact sums, row by row from the top.
    std::vector<FilmPixel> read() const { return pixels_.read(); }
    /// Samples that were cut at ±2^16.
    uint clamped() const { return clamped_.read().at(0); }

    uint width() const { return width_; }
    uint height() const { return height_; }
    std::size_t bytes() const { return pixels_.bytes() + picture_.bytes(); }

private:
    uint width_, height_;
    Kernel add_samples_, develop_;
    Buffer<FilmPixel> pixels_;
    Buffer<vec3> picture_;
    Buffer<uint> clamped_;
};

}  // namespace brandung
