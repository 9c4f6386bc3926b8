/// How tests inspect pixels.
#pragma once
#include <cstring>

#include "runtime/inspection/inspect_pixel.h"
#include "tests/support/probe.h"

namespace brandung {

/// A pixel as the scene's first camera has it, rendered in waves of `batch` rays on the test device.
inline InspectedPixel inspect(const Scene &scene, uint x, uint y, SampleRange kept, uint batch = 256) {
    Device &device = test_device();
    const CompiledScene compiled = compile(scene);
    const DeviceScene on_device(device, compiled);
    Film film(device, scene.film.window());
    Renderer renderer(device, scene, compiled, on_device, scene.cameras.at(0), {batch, {}});
    return inspect_pixel({device, on_device, renderer, film, scene.film.spp, batch}, x, y, kept);
}

inline bool same_bits(const auto &a, const auto &b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace brandung
