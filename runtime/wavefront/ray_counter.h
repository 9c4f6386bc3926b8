/// Counts of rays and hits by kind.
#pragma once
#include <array>

#include "kernels/core/items.h"
#include "runtime/opencl/buffer.h"

namespace brandung {

struct RayCounts {
    std::array<std::uint64_t, RAY_KINDS> rays{}, hits{};
    std::uint64_t total() const { return rays[RAY_CAMERA] + rays[RAY_REFLECTED] + rays[RAY_REFRACTED] + rays[RAY_SHADOW]; }
};

/// Keeps on the device what the tracing stages' work-items have seen.
class RayCounter {
public:
    /// `work_items`: of the largest launch of a tracing stage.
    RayCounter(Device &device, std::size_t work_items) : tallies_(device, work_items) { tallies_.fill_zero(); }
    /// To which every launch of a tracing stage adds.
    Buffer<Tally> &tallies() { return tallies_; }

    RayCounts read() const {
        RayCounts counts;
        for (const Tally &tally : tallies_.read())
            for (uint kind = 0; kind < RAY_KINDS; ++kind) counts.rays[kind] += tally.rays[kind], counts.hits[kind] += tally.hits[kind];
        return counts;
    }
    std::size_t bytes() const { return tallies_.bytes(); }

private:
    Buffer<Tally> tallies_;
};

}  // namespace brandung
