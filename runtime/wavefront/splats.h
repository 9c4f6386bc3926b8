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
    /// `lists`: the generated files of the scene. Throws BuildError, and Error where the device cannot hold the weights of `batch` samples.
    Splats(Device &device, const FilmSettings &film, const Sources &lists, uint batch);

    /// Finds out what the batch's samples weigh.
    void weigh(const Batch &batch);
    /// From pixels to each of those that the filter reaches from them, themselves among these.
    const std::vector<Splat> &all() const { return all_; }
    /// Of the batch's samples, as kernels/stages/weigh_splats.cl has them.
    const Buffer<float> &weights() const { return weights_; }
    std::size_t bytes() const { return values_.bytes() + weights_.bytes(); }

private:
    Kernel weigh_;
    int reach_;        ///< of the filter [pixels]
    float intervals_;  ///< of its values in a pixel's width
    uint stride_;      ///< of weights
    Buffer<float> values_;
    Buffer<float> weights_;
    std::vector<Splat> all_;
};

}  // namespace brandung
