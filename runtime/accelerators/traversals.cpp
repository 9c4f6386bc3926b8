#include "runtime/accelerators/traversals.h"

#include <fmt/format.h>

#include <algorithm>

namespace brandung {
namespace {

/// Up to so many a row of rays is through all of them before the same rays are through a hierarchy; beyond the other number it takes for ever.
constexpr std::size_t few_primitives = 48, most_primitives = 2048;

bool pays(const Traversal &traversal, const DeviceInfo &device, const CompiledScene &scene) {
    if (traversal.for_few && scene.primitive_count > few_primitives) return false;
    return traversal.pays_on == Traversal::PaysOn::all || (traversal.pays_on == Traversal::PaysOn::cpus) == device.cpu;
}

}  // namespace

const std::vector<Traversal> &traversals() {
    using enum Traversal::PaysOn;
    using enum RayLanes;
    static const std::vector<Traversal> list = {
        {"packets", "intersect_packets", "trace_shadow_rays", eight, &AcceleratorKind::packets, cpus, true, false},
        {"rows", "intersect_rows", "trace_shadow_rays_rows", eight, &AcceleratorKind::rows, cpus, false, true},
        {"interleaved", "intersect_interleaved", "trace_shadow_rays_interleaved", eight, &AcceleratorKind::interleaved, cpus, false, false},
        {"scalar", "intersect", "trace_shadow_rays_singly", one, &AcceleratorKind::scalar, others, false, false},
        {"single", "intersect", "trace_shadow_rays_singly", eight, nullptr, all, false, false},
    };
    return list;
}

bool is_available(const Traversal &traversal, const DeviceInfo &device, const CompiledScene &scene) {
    if (traversal.for_few && (scene.instances || scene.primitive_count > most_primitives)) return false;
    return (device.cpu || pays(traversal, device, scene)) && (traversal.support == nullptr || scene.accelerator->*traversal.support);
}

const Traversal &traversal_of_render(bool coherent, const DeviceInfo &device, const CompiledScene &scene) {
    return *std::ranges::find_if(traversals(), [&](const Traversal &traversal) {
        return is_available(traversal, device, scene) && pays(traversal, device, scene) && (coherent || !traversal.for_coherent);
    });
}

Kernel traversal_kernel(Device &device, const Traversal &traversal, const char *Traversal::*question, const CompiledScene &compiled, Times times) {
    const char *stage = traversal.*question;
    return Kernel(device, fmt::format("kernels/stages/{}.cl", stage), stage, specialize(compiled, traversal.lanes, times));
}

}  // namespace brandung
