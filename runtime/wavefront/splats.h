/// Splats: samples that count in all pixels that the filter reaches from where they lie.
#pragma once
#include "kernels/filters/splat.h"
#include "runtime/opencl/kernel.h"
#include "runtime/wavefront/batch.h"
#include "scene/filters/filter.h"

namespace brandung {

/// What kernels need that add a batch's samples to the pixels about theirs. All of a batch is added to one of these before the next, so that no two
/// pixels add to one at once.
class Splats {
public:
    /// `lists`: the generated files of the scene. Throws BuildError, and Error where the device cannot hold the places of `batch` samples.
    Splats(Device &device, const FilmSettings &film, const Sources &lists, uint batch);

    /// Finds out where the batch's samples lie in their pixels.
    void place(const Batch &batch) { place_(batch.count(), batch.params, several(batch.pixels, 1.0 / batch.params.samples), batch.count(), places_); }
    /// From pixels to each of those that the filter reaches from them, themselves among these.
    const std::vector<Splat> &all() const { return all_; }
    /// f / f(0) from the centre to the radius, FILTER_INTERVALS + 1 values.
    const Buffer<float> &filter_values() const { return values_; }
    /// Of the samples of the batch, in [0, 1)².
    const Buffer<vec2> &places() const { return places_; }
    std::size_t bytes() const { return values_.bytes() + places_.bytes(); }

private:
    Kernel place_;
    Buffer<float> values_;
    Buffer<vec2> places_;
    std::vector<Splat> all_;
};

}  // namespace brandung
