/// TracedScene: a scene on the device, and what rays meet in it.
#pragma once
#include <limits>
#include <string>
#include <vector>

#include "kernels/core/items.h"
#include "kernels/primitives/surface.h"
#include "runtime/accelerators/traversals.h"
#include "runtime/opencl/kernel.h"
#include "runtime/wavefront/device_scene.h"
#include "scene/accelerators/accelerator.h"

namespace brandung {

Ray make_ray(vec3 origin, vec3 direction, float t_max = std::numeric_limits<float>::infinity(), uint kind = RAY_CAMERA);

class TracedScene {
public:
    /// Sets the scene's accelerator.
    TracedScene(Scene &scene, const std::string &accelerator);
    explicit TracedScene(CompiledScene compiled);

    /// By stages/intersect.cl, one ray after another.
    std::vector<Hit> closest_hits(const std::vector<Ray> &rays) { return closest_hits(traversals().back(), rays); }
    /// By one of traversals().
    std::vector<Hit> closest_hits(const Traversal &traversal, const std::vector<Ray> &rays);
    /// The same: 1 where nothing is met before t_max.
    std::vector<std::uint8_t> visible(const Traversal &traversal, const std::vector<Ray> &rays);
    /// By primitives/primitive.cl; all zero where nothing was hit.
    std::vector<Surface> surfaces(const std::vector<Ray> &rays, const std::vector<Hit> &hits, const std::vector<uint> &instances = {});

    /// In scenes with instances: that of the primitive which each ray leaves; where they are fewer than rays, the last is used for the rest.
    void leave_instances(const std::vector<uint> &sources) { sources_ = sources; }
    /// Those of the last closest hits; 0 in scenes without instances.
    const std::vector<uint> &instances() const { return instances_; }

    /// In scenes with media: which of the last closest hits have others at nearly the same place.
    const std::vector<std::uint8_t> &crowded() const { return crowded_; }

    /// Those that there are, the last of which every accelerator has.
    std::vector<Traversal> traversals() const;

    /// Sums of what the last call's work-items counted.
    const Tally &tally() const { return tally_; }
    const CompiledScene &compiled() const { return compiled_; }
    const DeviceScene &on_device() const { return on_device_; }

private:
    CompiledScene compiled_;
    DeviceScene on_device_;
    Tally tally_{};
    std::vector<uint> sources_ = {0}, instances_;
    std::vector<std::uint8_t> crowded_;
};

}  // namespace brandung
