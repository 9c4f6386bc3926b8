/// Traversals: the ways in which kernels of a render find what rays meet.
#pragma once
#include <vector>

#include "runtime/opencl/device.h"
#include "runtime/opencl/kernel.h"
#include "runtime/wavefront/specialization.h"
#include "scene/accelerators/accelerator.h"

namespace brandung {

/// A stage per question, kernels/stages/<name>.cl. All of them have the same answers.
struct Traversal {
    /// Of devices: on which it pays. CPUs can run the others too.
    enum class PaysOn { all, cpus, others };
    /// Of rays: those that stay together; any in scenes with few primitives, all of which it goes through; any in scenes with primitives at the root
    /// of their hierarchy.
    enum class PaysFor { all_rays, coherent_rays, few_primitives, blocks_at_root };
    const char *name;
    const char *closest_hit;         ///< has the parameters of kernels/stages/intersect.cl
    const char *any_hit;             ///< and of kernels/stages/trace_shadow_rays_singly.cl
    RayLanes lanes;                  ///< for which they are compiled
    bool AcceleratorKind::*support;  ///< what the accelerator must have; null: all have it
    PaysOn pays_on;
    PaysFor pays_for;
    bool instances;  ///< knows them
};
/// THE list of traversals: of those that there are and that pay, a render takes the first.
const std::vector<Traversal> &traversals();

/// Whether the scene's accelerator has it, and the device can be asked to run it: a CPU any, so that all can be compared there, others what pays on
/// them.
bool is_available(const Traversal &traversal, const DeviceInfo &device, const CompiledScene &scene);
/// The one that a render takes for rays that stay together, or else go their own ways.
const Traversal &traversal_of_render(bool coherent, const DeviceInfo &device, const CompiledScene &scene);

/// One of its stages: &Traversal::closest_hit or any_hit.
Kernel traversal_kernel(Device &device, const Traversal &traversal, const char *Traversal::*question, const CompiledScene &compiled,
                        Times times = Times::of_rays);

/// Rays from the eye stay together, and so does what mirrors and glass make of them once; paths scatter, and the others go their own ways.
inline bool are_coherent(uint generation, bool paths) { return generation == 0 || (generation == 1 && !paths); }

/// Shadow rays from the first reflections are scattered already.
inline bool are_shadow_rays_coherent(uint generation) { return generation == 0; }

}  // namespace brandung
