/// Renderer: one rendering job, from work to film.
#pragma once
#include <functional>

#include "runtime/integrators/integrator.h"
#include "runtime/schedule.h"
#include "runtime/wavefront/aovs.h"
#include "runtime/wavefront/film.h"
#include "scene/cameras/camera.h"

namespace brandung {

struct RenderProgress {
    std::uint64_t samples_done = 0, samples_total = 0;  ///< the total may turn out to be less, where a rule ends the render
    uint spp = 0;                                       ///< samples of every pixel, by whole passes
    double seconds = 0;
    double part = 0;                     ///< that is done, from 0 to 1
    std::optional<double> seconds_left;  ///< as far as rules say it
    bool open_ended = false;             ///< the total is no number that anybody has asked for
    std::optional<Noise> noise;          ///< as it was after a pass, now and then
};

struct RenderOptions {
    uint batch = default_batch;  ///< rays per wave
    WatchSteps on_step{};        ///< of the integrator's loop: within batches, where the film is not whole and no observer could stop the render
    StopRules stop{};
};

/// Is told of a render under way after its batches, and may look at the film.
struct Observer {
    double seconds = 0;  ///< that pass at least from the beginning, or from the end of one call, to the next call; 0: after every batch
    std::function<bool(const RenderProgress &)> observe;  ///< false stops the render, once all have been told
};

/// What ended a render.
enum class StoppedBy { samples, error, time, observer, failure };

/// How a render ended; the film has the samples of whole batches.
struct RenderEnd {
    StoppedBy stopped_by = StoppedBy::samples;
    bool complete() const { return stopped_by != StoppedBy::observer && stopped_by != StoppedBy::failure; }  ///< as the rules want it
    std::string failure;  ///< what the device could not do, if that ended it
    std::uint64_t samples_done = 0, samples_total = 0;
    bool open_ended = false;     ///< as of RenderProgress
    std::optional<Noise> noise;  ///< of the film, where it has two samples of every pixel
    uint spp = 0;                ///< as of RenderProgress
};

class Renderer {
public:
    /// Builds kernels and allocates everything but the film and the levels of rays, which are allocated when first needed. Throws SceneError for
    /// settings that contradict each other, BuildError, and Error where the device cannot hold that much.
    Renderer(Device &device, const Scene &scene, const CompiledScene &compiled, const DeviceScene &on_device, const CameraDescription &camera,
             RenderOptions options);
    /// Renders all samples, or as many as the rules ask for, into the film, and what they hit first into `aovs` if given. Throws Error if the first
    /// batch fails; if a later one does, what there is so far is kept, as it is where an observer throws.
    RenderEnd render(Film &film, const std::vector<Observer> &observers = {}, Aovs *aovs = nullptr);

    /// Renders samples first ... first + samples of one pixel, at most as many as rays in a wave, into the film, and gives what was added to
    /// it. Shows the waves to `observer` if there is one.
    std::vector<Sample> render_pixel(Film &film, uint x, uint y, uint first, uint samples, WaveObserver *observer);

    /// Shows `observer` the waves of the same samples of several pixels, x in the lower 16 bits and y in the upper: at most as many samples in all
    /// as rays in a wave. No film gets them.
    void show(const std::vector<uint> &pixels, uint first, uint samples, WaveObserver &observer);

    /// Looks from another camera, whose eye is in the same media, from the next render on.
    void look_from(const CameraDescription &camera);

    const Integrator &integrator() const { return *integrator_; }
    const Filter &filter() const { return filter_; }
    /// Bytes of all buffers beside scene and film, at most.
    std::size_t wave_bytes() const;

private:
    StoppedBy render_passes(Film &film, RenderProgress &progress, const std::vector<Observer> &observers, Aovs *aovs);
    Batch batch_of(const std::vector<uint> &pixels, uint first, uint samples, Aovs *aovs);
    void render_batch(Film &film, const std::vector<uint> &pixels, uint first, uint samples, Aovs *aovs, WaveObserver *observer);

    Device &device_;
    const FilmSettings film_settings_;
    RenderOptions options_;
    const Shutter scene_shutter_;
    Camera camera_;
    Buffer<MotionPart> camera_motion_;
    ShutterParams shutter_;
    std::vector<uint> interior_;  ///< media that the eye is in
    Filter filter_;
    std::unique_ptr<Integrator> integrator_;
    Buffer<uint> pixels_;
    Buffer<Sample> samples_;
};

}  // namespace brandung
