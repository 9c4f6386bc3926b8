/// Integrators: how light gets to the eye.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "runtime/integrators/wave_observer.h"
#include "runtime/wavefront/batch.h"
#include "runtime/wavefront/device_scene.h"
#include "runtime/wavefront/filter.h"
#include "runtime/wavefront/ray_counter.h"
#include "runtime/wavefront/wave_step.h"
#include "scene/cameras/camera.h"

namespace brandung {

/// What a scene lacks, so that an integrator neither compiled, allocated nor launched it.
struct Skipped {
    std::string name, why;
};

/// Light that an integrator leaves out of its pictures.
struct NotShown {
    std::string name, why;
};

/// What makes a picture wrong beyond noise, however many samples it has.
struct Bias {
    std::string name, why;
};

class Integrator {
public:
    virtual ~Integrator() = default;
    /// Computes the radiance of the batch's samples, and shows each wave to `observer`, if there is one. Returns when everything is queued; the
    /// device may still be at work.
    virtual void render(const Batch &batch, Buffer<Sample> &samples, WaveObserver *observer = nullptr) = 0;
    virtual RayCounts counts() const = 0;
    /// Contributions that were not finite, and so were not added.
    virtual std::uint64_t refused() const = 0;
    /// How often a ray entered a medium when its list of media was full, so that the medium was left out.
    virtual std::uint64_t media_lost() const = 0;
    /// Bytes that its waves take at most, whatever the picture's size and samples.
    virtual std::size_t wave_bytes() const = 0;
    virtual std::vector<Skipped> skipped() const = 0;
    /// What its settings have cut off so far.
    virtual std::vector<Bias> biases() const = 0;
    /// What it cannot show, as it is set, that this scene may have.
    virtual std::vector<NotShown> not_shown() const = 0;
};

struct IntegratorJob {
    Device &device;
    const Scene &scene;
    const CompiledScene &compiled;
    const DeviceScene &on_device;
    const CameraKind &camera;
    bool camera_moves;
    const Filter &filter;  ///< must live as long as the integrator
    uint batch;            ///< rays per wave
    const WatchSteps &on_step;
};
struct IntegratorKind {
    const char *name;
    std::unique_ptr<Integrator> (*make)(const IntegratorJob &job);
};
const std::vector<IntegratorKind> &integrator_kinds();
/// The one that the scene asks for. Throws SceneError, with the place where it does and the list of names, if there is none of that name.
const IntegratorKind &integrator_of(const Scene &scene);

}  // namespace brandung
