/// One pixel of a render, with everything that happened to some of its samples.
#pragma once
#include <vector>

#include "runtime/inspection/ray_tree.h"
#include "runtime/renderer.h"

namespace brandung {

struct InspectedSample {
    uint number;     ///< of the pixel's samples
    TracedRay ray;   ///< from the eye
    Sample sum;      ///< of all contributions
    Sample weighed;  ///< as it was added to the film: times the filter's weight
};

struct InspectedPixel {
    std::vector<InspectedSample> samples;
    FilmPixel film;     ///< of all samples of the pixel, the same as a render's
    Spectrum radiance;  ///< developed from it, the same as the picture's
};

/// Samples first ... first + count of a pixel.
struct SampleRange {
    uint first, count;
};

/// What a renderer works on, with its batch: rays per wave.
struct InspectedRender {
    Device &device;
    const DeviceScene &on_device;
    Renderer &renderer;
    Film &film;
    uint spp, batch;
};

/// Renders all samples of one pixel into the film, which is black, and keeps the trees of those in `kept`.
InspectedPixel inspect_pixel(const InspectedRender &render, uint x, uint y, SampleRange kept);

}  // namespace brandung
