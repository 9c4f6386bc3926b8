#include "runtime/accelerators/traversals.h"

#include "runtime/integrators/coherence.h"

namespace brandung {

const std::vector<Traversal> &traversals() {
    static const std::vector<Traversal> all = {
        {"packets", "intersect_packets", "trace_shadow_rays", true},
        {"single", "intersect", "trace_shadow_rays_singly", false},
    };
    return all;
}

bool is_available(const Traversal &traversal, const Device &device, const CompiledScene &compiled) {
    return !traversal.packets || traces_packets(device, compiled);
}

const Traversal &traversal_of_render(bool coherent, const Device &device, const CompiledScene &compiled) {
    return traversals()[coherent && traces_packets(device, compiled) ? 0 : 1];
}

}  // namespace brandung
