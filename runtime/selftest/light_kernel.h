/// The kernel kernels/selftest/lights.cl, and what it samples.
#pragma once
#include <vector>

#include "kernels/lights/light.h"
#include "kernels/primitives/instance.h"
#include "runtime/opencl/kernel.h"
#include "scene/lights/light.h"

namespace brandung {

/// Light i at point i. Lights name instances and faces by their places here.
struct LitPoints {
    std::vector<Light> lights;
    std::vector<vec3> points;
    std::vector<uint> branches;
    std::vector<Instance> instances = std::vector<Instance>(1);  ///< the first is the world
    std::vector<EmissiveFace> faces;
};

class LightKernel {
public:
    /// Builds it. Throws Error.
    explicit LightKernel(Device &device);
    std::vector<LightSample> operator()(const LitPoints &lit);

private:
    Device &device_;
    Kernel kernel_;
};

}  // namespace brandung
