/// RaySample: the rays that a scene's render traces, for those who try accelerators on them.
#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "kernels/core/items.h"
#include "runtime/renderer.h"

namespace brandung {

/// Rays of one use, in the order in which waves trace them; side by side those of one wave, of shadow rays those of one row of lights.
struct RayQueue {
    enum class Use { camera, secondary, shadow, random };
    Use use;
    bool shadow;    ///< asks whether anything is met before t_max, not for the closest hit
    bool coherent;  ///< a render traces these in packets, where there are some
    std::vector<Ray> rays;
    std::vector<uint> sources;  ///< instances of the primitives that the rays leave; 0 in scenes without
    std::size_t count() const { return rays.size(); }
};

/// The queues of a render: camera, secondary in packets and single, shadow in packets and single.
using RaySample = std::vector<RayQueue>;

/// Runs the integrator for the first sample of pixels of the window, and takes its rays as begun: with `most` all over the window at most about so
/// many of each use, else all. Both pixels and rays are chosen in runs of 64, evenly spread, so that neighbours stay together. Returns what there is
/// when `goes_on` says no, which it is asked after each batch of at most `batch` pixels, as many as the renderer has rays in a wave.
RaySample sample_rays(Renderer &renderer, const Window &window, uint batch, std::size_t most = SIZE_MAX,
                      const std::function<bool(double part)> &goes_on = {});

/// So many rays of each use.
std::size_t count_of(const RaySample &sample, RayQueue::Use use);

}  // namespace brandung
