/// How often the depth limit has an effect.
#pragma once
#include "runtime/integrators/integrator.h"
#include "runtime/wavefront/levels.h"

namespace brandung {

class CutRays {
public:
    /// `flags`: MATERIAL_..., of which a material that would send further rays has one.
    CutRays(const IntegratorJob &job, uint flags)
        : flags_(flags), kernel_(job.device, "kernels/stages/count_cut_paths.cl", "count_cut_paths", job.on_device.lists()), cut_(job.device, 1) {
        cut_.fill_zero();
    }

    /// Counts those that end at the hits of this wave.
    void count(const Wave &wave, const DeviceScene &scene, const Buffer<SurfacePoint> &points) {
        kernel_(wave.count, scene.tables(), flags_, wave.count, points, shared(cut_));
    }
    std::uint64_t read() const { return cut_.read().at(0); }

private:
    uint flags_;
    Kernel kernel_;
    Buffer<std::uint64_t> cut_;
};

}  // namespace brandung
