#include "runtime/selftest/light_kernel.h"

#include <numeric>

#include "runtime/wavefront/specialization.h"
#include "scene/accelerators/accelerator.h"
#include "scene/compilation/arena.h"

namespace brandung {
namespace {

/// Of a scene with lights of every kind.
Sources lists_with_all_lights() {
    CompiledScene scene;
    scene.accelerator = &find_accelerator("none");
    scene.instances = scene.emissive_instances = true;
    scene.lights.resize(light_kinds().size());
    std::iota(scene.lights.begin(), scene.lights.end(), 0u);
    return specialize(scene, RayLanes::eight);
}

}  // namespace

LightKernel::LightKernel(Device &device) : device_(device), kernel_(device, "kernels/selftest/lights.cl", "test_lights", lists_with_all_lights()) {}

std::vector<LightSample> LightKernel::operator()(const LitPoints &lit) {
    std::vector<std::byte> bytes;
    Arena arena(bytes);
    SceneHeader header{};
    header.instances = arena.add(lit.instances);
    header.emissive_faces = arena.add(lit.faces);
    Buffer<LightSample> samples(device_, lit.lights.size());
    kernel_(lit.lights.size(), Buffer<SceneHeader>(device_, std::vector{header}), Buffer<std::byte>(device_, bytes),
            Buffer<Light>(device_, lit.lights), Buffer<vec3>(device_, lit.points), Buffer<uint>(device_, lit.branches),
            static_cast<uint>(lit.lights.size()), samples);
    std::vector<LightSample> read = samples.read();
    device_.finish();
    return read;
}

}  // namespace brandung
