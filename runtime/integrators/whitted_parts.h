/// Parts of Whitted's integrator that only some scenes need: each has kernels and what they write to.
#pragma once
#include "runtime/integrators/cut_rays.h"
#include "runtime/integrators/shadows.h"
#include "runtime/wavefront/compaction.h"

namespace brandung {

inline constexpr const char *whitted_cl = "kernels/integrators/whitted.cl";

/// Mirrored and refracted rays: only where a material sends them.
struct Secondary {
    Secondary(const IntegratorJob &job, uint branching)
        : spawn(job.device, whitted_cl, "spawn_whitted", job.on_device.lists()),
          compact(job.device, std::size_t{job.batch} * branching, 1),
          alive(job.device, std::size_t{job.batch} * branching),
          cut(job, MATERIAL_REFLECTS | MATERIAL_TRANSMITS) {}
    Kernel spawn;
    Compaction compact;
    Buffer<std::uint8_t> alive;
    CutRays cut;
    std::size_t bytes() const { return compact.bytes() + alive.bytes(); }
};

/// What transparent objects let through of the light: only on request, and only where a material transmits.
struct ShadowFilter {
    ShadowFilter(const IntegratorJob &job, std::size_t slots)
        : filter(job.device, "kernels/stages/filter_shadow_rays.cl", "filter_shadow_rays", job.on_device.lists()), filters(job.device, slots) {}
    Kernel filter;
    Buffer<Spectrum> filters;  ///< per shadow ray
};

}  // namespace brandung
