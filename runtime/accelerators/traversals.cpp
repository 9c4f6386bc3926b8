#include "runtime/accelerators/traversals.h"

#include <fmt/format.h>

#include <algorithm>

namespace brandung {
namespace {

/// Up to so many a row of rays is through all of them before the same rays are through a hierarchy; beyond the other number it takes for ever.
constexpr std::size_t few = 48, most = 2048;

bool pays_on(const Traversal &traversal, const DeviceInfo &device) {
    return traversal.pays_on == Traversal::PaysOn::all || (traversal.pays_on == Traversal::PaysOn::cpus) == device.cpu;
}

bool pays(const Traversal &traversal, bool coherent, const DeviceInfo &device, const CompiledScene &scene) {
    using enum Traversal::PaysFor;
    if (traversal.pays_for == coherent_rays && !coherent) return false;
    if (traversal.pays_for == few_primitives && scene.primitive_count > few) return false;
    if (traversal.pays_for == blocks_at_root && !scene.blocks_at_root) return false;
    return pays_on(traversal, device);
}

}  // namespace

const std::vector<Traversal> &traversals() {
    using enum Traversal::PaysOn;
    using enum Traversal::PaysFor;
    using enum RayLanes;
    static const std::vector<Traversal> list = {
        {"packets", "intersect_packets", "trace_shadow_rays", eight, &AcceleratorKind::packets, cpus, coherent_rays, true},
        {"rows", "intersect_rows", "trace_shadow_rays_rows", eight, &AcceleratorKind::rows, cpus, few_primitives, false},
        {"root_rows", "intersect_root_rows", "trace_shadow_rays_root_rows", eight, &AcceleratorKind::interleaved, cpus, blocks_at_root, false},
        {"interleaved", "intersect_interleaved", "trace_shadow_rays_interleaved", eight, &AcceleratorKind::interleaved, cpus, all_rays, true},
        {"scalar", "intersect", "trace_shadow_rays_singly", one, &AcceleratorKind::scalar, others, all_rays, true},
        {"single", "intersect", "trace_shadow_rays_singly", eight, nullptr, all, all_rays, true},
    };
    return list;
}

bool is_available(const Traversal &traversal, const DeviceInfo &device, const CompiledScene &scene) {
    if (traversal.pays_for == Traversal::PaysFor::few_primitives && scene.primitive_count > most) return false;
    if (scene.instances && !traversal.instances) return false;
    return (device.cpu || pays_on(traversal, device)) && (traversal.support == nullptr || scene.accelerator->*traversal.support);
}

const Traversal &traversal_of_render(bool coherent, const DeviceInfo &device, const CompiledScene &scene) {
    return *std::ranges::find_if(
        traversals(), [&](const Traversal &traversal) { return is_available(traversal, device, scene) && pays(traversal, coherent, device, scene); });
}

Kernel traversal_kernel(Device &device, const Traversal &traversal, const char *Traversal::*question, const CompiledScene &compiled, Times times) {
    const char *stage = traversal.*question;
    return Kernel(device, fmt::format("kernels/stages/{}.cl", stage), stage, specialize(compiled, traversal.lanes, times));
}

}  // namespace brandung
