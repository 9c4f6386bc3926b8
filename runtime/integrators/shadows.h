/// Shadows: rays that ask whether lights are visible.
#pragma once
#include <optional>

#include "runtime/integrators/stages.h"
#include "runtime/wavefront/compaction.h"

namespace brandung {

/// Rows of shadow rays, `stride` slots each; the item's ray lies at its place in the row. Only where there are lights.
struct Shadows {
    /// Of launches over so many items in so many rows.
    Shadows(const IntegratorJob &job, uint items, uint rows, bool bounces)
        : stride(items + 16),  // strides that are powers of two fall into the same cache sets
          rows(rows),
          trace_together(tracing_kernel(job, true, &Traversal::any_hit)),
          compact(job.device, stride, rows),
          rays(job.device, std::size_t{stride} * rows),
          visible(job.device, std::size_t{stride} * rows),
          live(job.device, std::size_t{stride} * rows) {
        if (bounces) trace_apart.emplace(tracing_kernel(job, false, &Traversal::any_hit));
    }
    /// Fewer rows have the more room for items, more rows less.
    void share_among(uint rows_in_use) {
        rows = rows_in_use;
        stride = static_cast<uint>(rays.size() / rows);
    }
    /// Lists those among the first `count` of each of the first `used` rows for which `visible` says that they ask.
    void list(uint count, uint used) { compact(visible, stride, count, used, 0, 0, live); }
    /// Leaves in `visible` whether anything is in the way of those that are listed. They leave from hits in `instances`.
    void trace(const DeviceScene &scene, uint generation, uint count, uint used, Access instances, RayCounter &counter) {
        Kernel &trace = are_shadow_rays_coherent(generation) ? trace_together : *trace_apart;
        trace(Grid(count, used), scene, in_rows(live, rows), shared(compact.counts()), stride, in_rows(rays, rows), instances, in_rows(visible, rows),
              shared(counter.tallies()));
    }

    uint stride, rows;
    Kernel trace_together;
    std::optional<Kernel> trace_apart;
    Compaction compact;
    Buffer<Ray> rays;
    Buffer<std::uint8_t> visible;
    Buffer<uint> live;
    std::size_t bytes() const { return compact.bytes() + rays.bytes() + visible.bytes() + live.bytes(); }
};

}  // namespace brandung
