/// Traversals: the ways in which kernels of a render find what rays meet.
#pragma once
#include <vector>

#include "runtime/opencl/device.h"
#include "scene/accelerators/accelerator.h"
#include "scene/compile.h"

namespace brandung {

/// A stage per question, kernels/stages/<name>.cl. All of them have the same answers.
struct Traversal {
    const char *name;
    const char *closest_hit;         ///< has the parameters of kernels/stages/intersect.cl
    const char *any_hit;             ///< and of kernels/stages/trace_shadow_rays_singly.cl
    bool AcceleratorKind::*support;  ///< what the accelerator must have; null: all have it
    bool for_coherent;               ///< pays for rays that stay together only
};
/// THE list of traversals: of those that there are and that pay, a render takes the first.
const std::vector<Traversal> &traversals();

/// Whether the accelerator has it, on such a device: what traces several rays at once pays where a work-item has many.
bool is_available(const Traversal &traversal, const Device &device, const CompiledScene &compiled);
/// The one that a render takes for rays that stay together, or else go their own ways.
const Traversal &traversal_of_render(bool coherent, const Device &device, const CompiledScene &compiled);

/// Rays from the eye and their first reflections stay together, the others go their own ways.
inline bool are_coherent(uint generation) { return generation <= 1; }

/// Shadow rays from the first reflections are scattered already.
inline bool are_shadow_rays_coherent(uint generation) { return generation == 0; }

}  // namespace brandung
