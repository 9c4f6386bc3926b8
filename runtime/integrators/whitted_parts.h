/// Parts of Whitted's integrator that only some scenes need: each has kernels and what they write to.
#pragma once
#include <fmt/format.h>

#include <optional>

#include "runtime/accelerators/traversals.h"
#include "runtime/integrators/integrator.h"
#include "runtime/wavefront/compaction.h"

namespace brandung {

inline constexpr const char *whitted_cl = "kernels/integrators/whitted.cl";

/// For the closest hits of rays that stay together, or else go their own ways; or for whether they meet anything.
inline Kernel tracing_kernel(const IntegratorJob &job, bool coherent, const char *Traversal::*question) {
    const Traversal &traversal = traversal_of_render(coherent, job.device.info(), *job.compiled.accelerator);
    return traversal_kernel(job.device, traversal, question, job.compiled);
}

/// Mirrored and refracted rays: only where a material sends them.
struct Secondary {
    Secondary(const IntegratorJob &job, uint branching)
        : spawn(job.device, whitted_cl, "spawn_whitted", job.on_device.lists()),
          compact(job.device, std::size_t{job.batch} * branching, 1),
          alive(job.device, std::size_t{job.batch} * branching),
          count_cut(job.device, "kernels/stages/count_cut_paths.cl", "count_cut_paths", job.on_device.lists()),
          cut(job.device, 1) {
        cut.fill_zero();
    }
    Kernel spawn;
    Compaction compact;
    Buffer<std::uint8_t> alive;
    Kernel count_cut;
    Buffer<std::uint64_t> cut;  ///< hits at the depth limit that would send further rays
    std::size_t bytes() const { return compact.bytes() + alive.bytes(); }
};

/// Interfaces between media: only where a material transmits.
struct Interfaces {
    explicit Interfaces(const IntegratorJob &job)
        : find(job.device, "kernels/stages/find_interfaces.cl", "find_interfaces", job.on_device.lists()),
          beyond(job.device, std::size_t{job.batch} * job.compiled.interior_size),
          etas(job.device, job.batch),
          crowded(job.device, job.batch),
          lost(job.device, 1) {
        lost.fill_zero();
    }
    Kernel find;
    Buffer<uint> beyond;  ///< lists of the media behind, as those of rays
    Buffer<float> etas;
    Buffer<std::uint8_t> crowded;
    Buffer<uint> lost;  ///< media that found no place
    std::size_t bytes() const { return beyond.bytes() + etas.bytes() + crowded.bytes(); }
};

/// Colours of pictures and vertices: only where the scene has some.
struct Pictures {
    explicit Pictures(const IntegratorJob &job)
        : look_up(job.device, "kernels/stages/look_up_textures.cl", "look_up_textures", job.on_device.lists()), tints(job.device, job.batch) {}
    Kernel look_up;
    Buffer<Tints> tints;
};

/// Shadow rays of a block of light records: row r, of `stride` slots, goes to the block's r-th. Only where there are lights.
struct Shadows {
    Shadows(const IntegratorJob &job, uint rows)
        : stride(job.batch + 16),  // strides that are powers of two fall into the same cache sets
          rows(rows),
          spawn(job.device, whitted_cl, "spawn_shadow_rays", job.on_device.lists()),
          trace_together(tracing_kernel(job, true, &Traversal::any_hit)),
          compact(job.device, stride, rows),
          rays(job.device, std::size_t{stride} * rows),
          visible(job.device, std::size_t{stride} * rows),
          live(job.device, std::size_t{stride} * rows) {
        if (branching(job.compiled) > 0) trace_apart.emplace(tracing_kernel(job, false, &Traversal::any_hit));
    }
    uint stride, rows;
    Kernel spawn, trace_together;
    std::optional<Kernel> trace_apart;
    Compaction compact;
    Buffer<Ray> rays;
    Buffer<std::uint8_t> visible;
    Buffer<uint> live;
    std::size_t bytes() const { return compact.bytes() + rays.bytes() + visible.bytes() + live.bytes(); }
};

/// What transparent objects let through of the light: only on request, and only where a material transmits.
struct ShadowFilter {
    ShadowFilter(const IntegratorJob &job, std::size_t slots)
        : filter(job.device, "kernels/stages/filter_shadow_rays.cl", "filter_shadow_rays", job.on_device.lists()), filters(job.device, slots) {}
    Kernel filter;
    Buffer<Spectrum> filters;  ///< per shadow ray
};

}  // namespace brandung
