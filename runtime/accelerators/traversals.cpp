#include "runtime/accelerators/traversals.h"

#include <fmt/format.h>

#include <algorithm>

namespace brandung {
namespace {

bool pays(const Traversal &traversal, const DeviceInfo &device) {
    return traversal.pays_on == Traversal::PaysOn::all || (traversal.pays_on == Traversal::PaysOn::cpus) == device.cpu;
}

}  // namespace

const std::vector<Traversal> &traversals() {
    using enum Traversal::PaysOn;
    using enum RayLanes;
    static const std::vector<Traversal> list = {
        {"packets", "intersect_packets", "trace_shadow_rays", eight, &AcceleratorKind::packets, cpus, true},
        {"interleaved", "intersect_interleaved", "trace_shadow_rays_interleaved", eight, &AcceleratorKind::interleaved, cpus, false},
        {"scalar", "intersect", "trace_shadow_rays_singly", one, &AcceleratorKind::scalar, others, false},
        {"single", "intersect", "trace_shadow_rays_singly", eight, nullptr, all, false},
    };
    return list;
}

bool is_available(const Traversal &traversal, const DeviceInfo &device, const AcceleratorKind &accelerator) {
    return (device.cpu || pays(traversal, device)) && (traversal.support == nullptr || accelerator.*traversal.support);
}

const Traversal &traversal_of_render(bool coherent, const DeviceInfo &device, const AcceleratorKind &accelerator) {
    return *std::ranges::find_if(traversals(), [&](const Traversal &traversal) {
        return is_available(traversal, device, accelerator) && pays(traversal, device) && (coherent || !traversal.for_coherent);
    });
}

Kernel traversal_kernel(Device &device, const Traversal &traversal, const char *Traversal::*question, const CompiledScene &compiled) {
    const char *stage = traversal.*question;
    return Kernel(device, fmt::format("kernels/stages/{}.cl", stage), stage, specialize(compiled, traversal.lanes));
}

}  // namespace brandung
