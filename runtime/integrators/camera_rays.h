/// CameraRays: how a batch begins.
#pragma once
#include <optional>

#include "runtime/integrators/integrator.h"
#include "runtime/wavefront/compaction.h"
#include "runtime/wavefront/levels.h"

namespace brandung {

class CameraRays {
public:
    explicit CameraRays(const IntegratorJob &job);

    /// The rays of the batch's samples, in a level that has been started for as many; those that the camera does not see live no longer. All samples
    /// become black.
    void operator()(const Batch &batch, Level &first, Buffer<Sample> &samples);

    std::size_t work_items(std::size_t items) const { return generate_.work_items(items); }
    std::size_t bytes() const { return seen_.bytes() + (compact_ ? compact_->bytes() : 0); }

private:
    const Filter &filter_;
    Kernel generate_;
    uint place_words_;
    Buffer<std::uint8_t> seen_;  ///< only of cameras that do not see everywhere
    std::optional<Compaction> compact_;
};

}  // namespace brandung
