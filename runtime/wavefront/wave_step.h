/// WaveStep: what waits in the levels of rays at each step of an integrator's loop, for those who ask to be told.
#pragma once
#include <functional>
#include <vector>

#include "kernels/core/portable.h"

namespace brandung {

struct WaveStep {
    uint generation = 0;        ///< that a wave is taken from
    uint count = 0;             ///< rays of the wave; 0 at the end of a batch, when nothing waits any more
    std::vector<uint> waiting;  ///< live rays by generation, those of the wave still among them
};
/// Called whenever a wave is handed out, and at the end of a batch.
using WatchSteps = std::function<void(const WaveStep &)>;

}  // namespace brandung
