/// Parts of integrators that only some scenes need: each has kernels and what they write to.
#pragma once
#include "runtime/accelerators/traversals.h"
#include "runtime/integrators/integrator.h"

namespace brandung {

/// For the closest hits of rays that stay together, or else go their own ways; or for whether they meet anything.
inline Kernel tracing_kernel(const IntegratorJob &job, bool coherent, const char *Traversal::*question) {
    const Traversal &traversal = traversal_of_render(coherent, job.device.info(), job.compiled);
    return traversal_kernel(job.device, traversal, question, job.compiled);
}

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

/// Materials that choose among others: only where the scene has some.
struct Choices {
    explicit Choices(const IntegratorJob &job)
        : choose(job.device, "kernels/stages/choose_materials.cl", "choose_materials", job.on_device.lists()), chosen(job.device, job.batch) {}
    Kernel choose;
    Buffer<uint> chosen;  ///< the material of each hit
};

/// Where paths meet surfaces of several kinds, on CPUs.
struct Grouping {
    explicit Grouping(const IntegratorJob &job) : group(job.device, "kernels/stages/group_hits.cl", "group_hits", job.on_device.lists()) {}
    Kernel group;
};

/// Colours of pictures and vertices: only where the scene has some.
struct Pictures {
    explicit Pictures(const IntegratorJob &job)
        : look_up(job.device, "kernels/stages/look_up_textures.cl", "look_up_textures", job.on_device.lists()), tints(job.device, job.batch) {}
    Kernel look_up;
    Buffer<Tints> tints;
};

}  // namespace brandung
