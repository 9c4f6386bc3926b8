#include "runtime/accelerators/traversals.h"

#include <algorithm>

namespace brandung {

const std::vector<Traversal> &traversals() {
    static const std::vector<Traversal> all = {
        {"packets", "intersect_packets", "trace_shadow_rays", &AcceleratorKind::packets, true},
        {"interleaved", "intersect_interleaved", "trace_shadow_rays_interleaved", &AcceleratorKind::interleaved, false},
        {"single", "intersect", "trace_shadow_rays_singly", nullptr, false},
    };
    return all;
}

bool is_available(const Traversal &traversal, const Device &device, const CompiledScene &compiled) {
    return traversal.support == nullptr || (device.info().cpu && compiled.accelerator->*traversal.support);
}

const Traversal &traversal_of_render(bool coherent, const Device &device, const CompiledScene &compiled) {
    return *std::ranges::find_if(
        traversals(), [&](const Traversal &traversal) { return (coherent || !traversal.for_coherent) && is_available(traversal, device, compiled); });
}

}  // namespace brandung
