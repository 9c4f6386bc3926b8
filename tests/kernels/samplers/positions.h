/// Positions of pixels' samples, as a sampler draws them.
#pragma once
#include <string>
#include <vector>

#include "kernels/core/params.h"
#include "tests/support/probe.h"

namespace brandung {

/// With `use` above 0 the pairs of that use instead. `spp`: samples per pixel of the render.
inline std::vector<vec2> positions(const std::string &sampler, const std::vector<uint> &pixels, const std::vector<uint> &samples, uint seed,
                                   uint use = 0, uint spp = 64) {
    const BatchParams batch{.pixels = 0, .first_sample = 0, .samples = 0, .spp = spp, .seed = seed, .position = PIXEL_CENTER};
    return Probe("#include \"kernels/samplers/" + sampler + R"(.cl"
        kernel void probe(const global uint *pixels, const global uint *samples, const global BatchParams *batch, const global uint *use,
                          global vec2 *positions) {
            const uint i = get_global_id(0);
            positions[i] = *use == 0u ? sampler_pixel_position(pixels[i], samples[i], *batch) : sampler_pair(pixels[i], samples[i], whole_sample(), *use, *batch);
        })")
        .run<vec2>(pixels, samples, batch, use);
}

/// The pixels of a square picture.
inline std::vector<uint> some_pixels(uint width) {
    std::vector<uint> pixels;
    for (uint i = 0; i < width * width; ++i) pixels.push_back(i % width | (i / width) << 16);
    return pixels;
}

/// How far the mean x of a pixel's n samples is from 1/2: the mean over pixels, of the square and of itself.
struct RampError {
    double square, mean;
};
inline RampError ramp_error(const std::string &sampler, uint half, uint n, uint width) {
    std::vector<uint> pixels, samples;
    for (const uint pixel : some_pixels(width))
        for (uint i = 0; i < n; ++i) pixels.push_back(pixel), samples.push_back(2 * i + half);
    const std::vector<vec2> points = positions(sampler, pixels, samples, 3);
    RampError error{0, 0};
    const double count = double(width) * width;
    for (std::size_t p = 0; p < points.size(); p += n) {
        double mean = 0;
        for (uint i = 0; i < n; ++i) mean += double(points[p + i].x) / n;
        error.square += (mean - 0.5) * (mean - 0.5) / count, error.mean += (mean - 0.5) / count;
    }
    return error;
}

}  // namespace brandung
