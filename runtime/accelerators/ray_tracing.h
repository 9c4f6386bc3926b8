/// RayTracing: rays of a sample, traced by one accelerator as a render traces them, or one by one with counts of the work.
#pragma once
#include <map>

#include "kernels/accelerators/work.h"
#include "runtime/accelerators/ray_sample.h"
#include "runtime/accelerators/traversals.h"
#include "runtime/opencl/kernel.h"

namespace brandung {

/// A part of a queue.
struct RaySpan {
    bool shadow, coherent;
    std::span<const Ray> rays;
    std::span<const uint> sources;
};
/// Rays first ... first + count of a queue, fewer at its end.
RaySpan part_of(const RayQueue &queue, std::size_t first, std::size_t count);

/// What rays meet: of shadow rays `visible`, of others the rest, one per ray.
struct RayAnswers {
    std::vector<Hit> hits;
    std::vector<uint> instances;  ///< of the hits, 0 outside of all
    std::vector<std::uint8_t> visible;
    std::size_t count() const { return hits.empty() ? visible.size() : hits.size(); }
    /// Whether all bits of the answer to ray i are the same.
    bool is_same(const RayAnswers &other, std::size_t i) const;
};

/// Sums of Work over many rays.
struct WorkSums {
    std::uint64_t rays = 0, hits = 0;
    std::uint64_t steps = 0, cells = 0, empty_cells = 0, listed = 0, blocks = 0, tests = 0, missed = 0, idle = 0, served = 0;
    void add(const Work &work);
    void add(const WorkSums &sums);
};

/// Time that rays took [s].
struct TraceSeconds {
    double device;  ///< in kernels
    double wall;    ///< from before their launch until the host knows that they have ended
};

/// At most `batch` rays at once; where the scene moves, as it is at its first time.
class RayTracing {
public:
    RayTracing(Device &device, const CompiledScene &compiled, const DeviceScene &on_device, uint batch);
    /// By the stages that a render takes for such rays.
    TraceSeconds trace(const RaySpan &rays);
    /// By those of a traversal that is available.
    TraceSeconds trace(const RaySpan &rays, const Traversal &traversal);
    /// What the last trace() has found.
    RayAnswers answers() const;
    /// One ray after another by the counting kernels; adds to `sums`.
    RayAnswers count(const RaySpan &rays, WorkSums &sums);

private:
    Kernel &stage(const Traversal &traversal, const char *Traversal::*question);
    Kernel &counter(const std::string &name);
    void take(const RaySpan &rays);
    void launch(const RaySpan &rays, Kernel &kernel);

    Device &device_;
    const CompiledScene &compiled_;
    const DeviceScene &scene_;
    const Traversal &together_, &apart_;                            ///< of a render, for rays that stay together and that do not
    std::map<std::pair<std::string, std::string>, Kernel> stages_;  ///< that were needed so far, by names of traversal and kernel
    std::map<std::string, Kernel> counters_;                        ///< by name
    Buffer<Ray> rays_;
    Buffer<uint> sources_, live_, counts_;
    Buffer<Hit> hits_;
    Buffer<uint> instances_;
    Buffer<std::uint8_t> crowded_, visible_;
    Buffer<Work> works_;
    Buffer<Tally> tallies_;  ///< as many as the largest launch so far has work-items
    uint batch_;
    RaySpan taken_{};
};

}  // namespace brandung
