/// Counts of rays and hits by kind.
#pragma once
#include <array>

#include "kernels/core/items.h"
#include "runtime/opencl/kernel.h"

namespace brandung {

struct RayCounts {
    std::array<std::uint64_t, RAY_KINDS> rays{}, hits{};
    std::uint64_t total() const { return rays[RAY_CAMERA] + rays[RAY_REFLECTED] + rays[RAY_REFRACTED] + rays[RAY_SHADOW]; }
};

/// Adds up on the device what the tracing stages' work-items have seen.
class RayCounter {
public:
    /// `work_items`: of the largest launch of a tracing stage.
    RayCounter(Device &device, std::size_t work_items)
        : tally_(device, "kernels/stages/tally.cl", "tally", {}, 1), tallies_(device, work_items), totals_(device, 2 * RAY_KINDS) {
        totals_.fill_zero();
    }
    /// Where the next launch of a tracing stage writes its tallies.
    Buffer<Tally> &tallies() { return tallies_; }
    /// Adds the tallies of a launch that had so many work-items.
    void add(std::size_t work_items) { tally_(1, data_dependent(tallies_), static_cast<uint>(work_items), shared(totals_)); }

    RayCounts read() const {
        const std::vector<std::uint64_t> totals = totals_.read();
        RayCounts counts;
        for (uint kind = 0; kind < RAY_KINDS; ++kind) counts.rays[kind] = totals[kind], counts.hits[kind] = totals[RAY_KINDS + kind];
        return counts;
    }
    std::size_t bytes() const { return tallies_.bytes() + totals_.bytes(); }

private:
    Kernel tally_;
    Buffer<Tally> tallies_;
    Buffer<std::uint64_t> totals_;
};

}  // namespace brandung
