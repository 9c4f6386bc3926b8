#include "runtime/accelerators/traversals.h"

#include <algorithm>

namespace brandung {
namespace {

const Traversal &best_available(std::initializer_list<std::size_t> places, const Device &device, const CompiledScene &compiled) {
    return traversals()[*std::find_if(places.begin(), places.end(), [&](std::size_t i) { return is_available(traversals()[i], device, compiled); })];
}

constexpr std::size_t packets = 0, interleaved = 1, single = 2;  ///< places in the list

}  // namespace

const std::vector<Traversal> &traversals() {
    static const std::vector<Traversal> all = {
        {"packets", "intersect_packets", "trace_shadow_rays", &AcceleratorKind::packets},
        {"interleaved", "intersect_interleaved", "trace_shadow_rays_interleaved", &AcceleratorKind::interleaved},
        {"single", "intersect", "trace_shadow_rays_singly", nullptr},
    };
    return all;
}

bool is_available(const Traversal &traversal, const Device &device, const CompiledScene &compiled) {
    return traversal.support == nullptr || (device.info().cpu && compiled.accelerator->*traversal.support);
}

const Traversal &traversal_of_render(bool coherent, const Device &device, const CompiledScene &compiled) {
    return coherent ? best_available({packets, interleaved, single}, device, compiled) : best_available({interleaved, single}, device, compiled);
}

}  // namespace brandung
