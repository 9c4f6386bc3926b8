/// What a render did, as JSON and as text.
#pragma once
#include <nlohmann/json.hpp>

#include "runtime/renderer.h"

namespace brandung {

/// Wall-clock time of the phases of a render [s].
struct PhaseSeconds {
    double read = 0, scene = 0, accelerator = 0, kernels = 0, render = 0, write = 0, total = 0;
};

struct RenderReport {
    const Scene &scene;
    const CompiledScene &compiled;
    const Device &device;
    const Integrator &integrator;
    PhaseSeconds seconds;
    std::size_t scene_bytes = 0, wave_bytes = 0, film_bytes = 0;
    uint clamped = 0;
};

/// The fields of --stats: names are a promise.
nlohmann::json statistics(const RenderReport &report);
/// What the scene needs, what was skipped and why, one thing a line.
std::string explain(const Scene &scene, const CompiledScene &compiled, const Integrator &integrator);
/// {"spheres": 12, ...}: what is in the scene.
nlohmann::json scene_contents(const Scene &scene, const CompiledScene &compiled);

}  // namespace brandung
