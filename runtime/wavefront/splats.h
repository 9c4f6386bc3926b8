/// Splats: samples that count in all pixels that the filter reaches from where they lie.
#pragma once
#include "kernels/filters/splat.h"
#include "runtime/opencl/kernel.h"
#include "runtime/wavefront/batch.h"
#include "scene/filters/filter.h"

namespace brandung {

/// What kernels need that add a batch's samples to the pixels about theirs, in columns: a row of all the batch's pixels for each of a pixel's
/// samples. All of a batch is added to one of these pixels before the next, so that no two pixels add to one at once.
class Splats {
public:
    /// `lists`: the generated files of the scene. Throws BuildError, and Error where the device cannot hold the columns of `batch` samples.
    Splats(Device &device, const FilmSettings &film, const Sources &lists, uint batch);

    /// Finds out what the batch's samples weigh.
    void weigh(const Batch &batch);
    /// Makes the samples the batch's values(); clamped[0] counts those that were cut at ±2^16.
    void cut(const Batch &batch, const Buffer<Sample> &samples, Buffer<uint> &clamped);
    /// From pixels to each of those that the filter reaches from them, themselves among these.
    const std::vector<Splat> &all() const { return all_; }
    /// Of the batch's samples, as kernels/stages/weigh_splats.cl has them.
    const Buffer<float> &weights() const { return weights_; }
    /// Channels of its samples as kernels/stages/cut_samples.cl has them, each stride() from the one before.
    const Buffer<std::int64_t> &values() const { return values_; }
    uint stride() const { return stride_; }
    std::size_t bytes() const { return filter_values_.bytes() + weights_.bytes() + values_.bytes(); }

private:
    Kernel weigh_, cut_;
    int reach_;        ///< of the filter [pixels]
    float intervals_;  ///< of its values in a pixel's width
    uint stride_;      ///< from column to column
    Buffer<float> filter_values_, weights_;
    Buffer<std::int64_t> values_;
    std::vector<Splat> all_;
};

}  // namespace brandung
