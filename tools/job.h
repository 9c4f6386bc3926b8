/// Job: everything that a render prepares before its first ray.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "runtime/accelerators/choose_accelerator.h"
#include "runtime/opencl/seconds_now.h"
#include "runtime/renderer.h"
#include "tools/scene_options.h"

namespace brandung {

/// Wall-clock time of the phases of a render [s]; what has no value is not known yet.
struct PhaseSeconds {
    double read = 0;         ///< the scene file
    double scene = 0;        ///< from the scene to its arena, but for the accelerator
    double choice = 0;       ///< trying accelerators, for `auto`
    double accelerator = 0;  ///< building it
    double device = 0;       ///< choosing the device, and copying the arena to it
    double kernels = 0;      ///< building them, and allocating what they work on
    double render = 0;
    std::optional<double> write, total;
};

/// Runs a phase, adds the time it took to `seconds` and gives its result.
template <class Phase> auto timed(double &seconds, Phase phase) {
    struct Watch {
        double &seconds, start = seconds_now();
        ~Watch() { seconds += seconds_now() - start; }
    } const watch{seconds};
    return phase();
}

/// Who is told of what a job does; each may be empty.
struct JobWatch {
    std::function<void(const std::string &file)> on_build;  ///< before a kernel file is built
    std::function<void(const Build &)> on_built;
    std::function<void(const Launch &)> on_launch;
    WatchSteps on_step;
    WatchAccelerator on_accelerator{};
    std::function<void(const AcceleratorKind &)> on_trial{};  ///< before `auto` tries one
};

/// Why a device is not to be trusted, as far as is known; throws Error where that is so, unless it is taken all the same.
std::string check_trust(const DeviceInfo &device, bool take_it_all_the_same);

struct Job {
    /// `scene` must live as long. Throws SceneError and Error.
    Job(const Scene &scene, const SceneOptions &options, JobWatch watch = {}, const StopRules &stop = {});
    /// Looks from the camera turned by an angle [radians], and turns the headlight with it, if there is one.
    void turn(double angle);
    /// Of scene, film and waves, at most.
    std::size_t bytes() const { return on_device.bytes() + on_device.texture_bytes() + film_bytes() + renderer.wave_bytes(); }
    /// Of radiance and AOVs.
    std::size_t film_bytes() const { return film.bytes() + (aovs ? aovs->bytes() : 0); }

    PhaseSeconds seconds;
    const Scene &scene;
    const CameraDescription &camera;
    Device device;
    std::string distrust;                     ///< which self-test the device has failed, where it was taken all the same; empty else
    std::optional<AcceleratorChoice> choice;  ///< where the scene's accelerator is `auto`
    CompiledScene compiled;
    DeviceScene on_device;
    Film film;
    std::optional<Aovs> aovs;  ///< if the scene asks for any
    Renderer renderer;
};

}  // namespace brandung
