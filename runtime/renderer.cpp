#include "runtime/renderer.h"

#include <algorithm>

#include "runtime/opencl/seconds_now.h"
#include "runtime/wavefront/work.h"
#include "scene/error.h"
#include "scene/formats/limits.h"

namespace brandung {
namespace {

/// What all batches have in common.
BatchParams common_params(const FilmSettings &film) {
    return {.pixels = 0, .first_sample = 0, .samples = 0, .spp = film.spp, .seed = film.seed, .position = film.pixel};
}

FilmSettings checked(const Scene &scene) {
    if (scene.film.pixel == PIXEL_CORNER && scene.film.spp != 1)
        throw SceneError(scene.file + ": /film/pixel: 'corner' takes one sample per pixel, not " + std::to_string(scene.film.spp));
    if (scene.film.pixel == PIXEL_CORNER && filter_kinds()[scene.film.filter].has_radius)
        throw SceneError(scene.file + ": /film/filter: pixels at corners take no filter but the box");
    return scene.film;
}

/// An entry per transparent material that the eye is in; entries beyond the list's size are left out.
std::vector<uint> media_of_eye(const Scene &scene, const CompiledScene &compiled, const CameraDescription &camera) {
    std::vector<uint> entries;
    for (std::size_t m = 0; m < scene.materials.size(); ++m)
        if (std::find(camera.inside.begin(), camera.inside.end(), scene.materials[m].name) != camera.inside.end())
            entries.push_back(static_cast<uint>(m + 1) << 8 | 1u);
    entries.resize(compiled.interior_size);
    return entries;
}

ShutterParams shutter_params(const CameraDescription &camera, const Shutter &of_scene, std::size_t parts) {
    return {of_scene.place_of(camera.shutter.open), of_scene.place_of(camera.shutter.close), static_cast<uint>(parts)};
}

/// Tells observers of a render that begins now.
class Announcement {
public:
    explicit Announcement(const std::vector<Observer> &observers) : observers_(observers), told_(observers.size()) {}

    /// Those whose time has come, and what time it is; false if one of them stops the render.
    bool tell(RenderProgress &progress, const Schedule &schedule) {
        progress.seconds = seconds();
        const double of_samples = static_cast<double>(progress.samples_done) / static_cast<double>(progress.samples_total);
        progress.part = schedule.part(of_samples, progress.seconds);
        progress.seconds_left = schedule.seconds_left(progress.seconds);
        bool goes_on = true;
        for (std::size_t i = 0; i < observers_.size(); ++i) {
            if (progress.seconds - told_[i] < observers_[i].seconds) continue;
            if (!observers_[i].observe(progress)) goes_on = false;
            told_[i] = seconds();
        }
        return goes_on;
    }

    /// Since the render began.
    double seconds() const { return seconds_now() - start_; }

private:
    const std::vector<Observer> &observers_;
    std::vector<double> told_;  ///< when the calls ended
    double start_ = seconds_now();
};

/// The noise of a film now and then: it may take a hundredth of the time, unless somebody cannot do without.
class NoiseWatch {
public:
    NoiseWatch(const Film &film, bool always) : film_(film), always_(always) {}

    /// As known so many seconds after the beginning.
    const std::optional<Noise> &after_pass(double seconds) {
        if (!always_ && seconds < next_) return noise_;
        const double start = seconds_now();
        noise_ = film_.noise();
        const double cost = seconds_now() - start;
        next_ = seconds + std::max(1.0, 100 * cost);
        return noise_;
    }

private:
    const Film &film_;
    bool always_;
    double next_ = 1;
    std::optional<Noise> noise_;
};

}  // namespace

Renderer::Renderer(Device &device, const Scene &scene, const CompiledScene &compiled, const DeviceScene &on_device, const CameraDescription &camera,
                   RenderOptions options)
    : device_(device),
      film_settings_(checked(scene)),
      options_(std::move(options)),
      scene_shutter_(scene.shutter),
      camera_(make_camera(camera, film_settings_.width, film_settings_.height)),
      camera_motion_(device, camera_motion(camera, scene_shutter_).value()),
      shutter_(shutter_params(camera, scene_shutter_, camera_motion_.size())),
      interior_(media_of_eye(scene, compiled, camera)),
      filter_(device, film_settings_, on_device.lists(), options_.batch),
      integrator_(integrator_of(scene).make(
          {device, scene, compiled, on_device, camera_kinds()[camera.kind], !camera.keys.empty(), filter_, options_.batch, options_.on_step})),
      pixels_(device, options_.batch),
      samples_(device, options_.batch) {}

void Renderer::look_from(const CameraDescription &camera) {
    camera_ = make_camera(camera, film_settings_.width, film_settings_.height);
    camera_motion_ = Buffer<MotionPart>(device_, camera_motion(camera, scene_shutter_).value());
    shutter_ = shutter_params(camera, scene_shutter_, camera_motion_.size());
}

std::size_t Renderer::wave_bytes() const { return integrator_->wave_bytes() + filter_.bytes() + pixels_.bytes() + samples_.bytes(); }

RenderEnd Renderer::render(Film &film, const std::vector<Observer> &observers, Aovs *aovs) {
    RenderProgress progress{.samples_total = sampled_window(film_settings_).pixels() * film_settings_.spp,
                            .open_ended = film_settings_.spp == max_samples};
    RenderEnd end;
    try {
        end.stopped_by = render_passes(film, progress, observers, aovs);
    } catch (const Error &error) {
        if (progress.samples_done == 0) throw;
        end.stopped_by = StoppedBy::failure, end.failure = error.what();
    }
    end.samples_done = progress.samples_done, end.samples_total = progress.samples_total, end.open_ended = progress.open_ended;
    end.noise = progress.noise, end.spp = progress.spp;
    return end;
}

StoppedBy Renderer::render_passes(Film &film, RenderProgress &progress, const std::vector<Observer> &observers, Aovs *aovs) {
    Announcement announcement(observers);
    Schedule schedule(film_settings_, options_.batch, options_.stop);
    NoiseWatch noise(film, schedule.needs_noise());
    bool goes_on = true, in_time = true;
    for (uint samples = schedule.next_pass(); samples > 0; samples = schedule.next_pass()) {
        const uint pixels_at_once = options_.batch / samples;
        PixelOrder order(sampled_window(film_settings_));
        for (auto pixels = order.next(pixels_at_once); goes_on && in_time && !pixels.empty(); pixels = order.next(pixels_at_once)) {
            render_batch(film, pixels, schedule.samples_done(), samples, aovs, nullptr);
            if (progress.samples_done == 0) schedule.start_clock(announcement.seconds());
            progress.samples_done += pixels.size() * samples;
            in_time = !schedule.is_late(announcement.seconds());
            goes_on = announcement.tell(progress, schedule);
        }
        if (!goes_on || !in_time) break;
        progress.noise = noise.after_pass(announcement.seconds());
        schedule.end_pass(samples, announcement.seconds(), progress.noise);
        progress.spp = schedule.samples_done();
    }
    if (film_settings_.spp > 1) progress.noise = film.noise();
    if (progress.samples_done == progress.samples_total) return schedule.has_reached_error() ? StoppedBy::error : StoppedBy::samples;
    if (!goes_on) return StoppedBy::observer;
    progress.samples_total = progress.samples_done;
    announcement.tell(progress, schedule);
    return in_time ? StoppedBy::error : StoppedBy::time;
}

/// The pixels' samples first ... first + samples.
Batch Renderer::batch_of(const std::vector<uint> &pixels, uint first, uint samples, Aovs *aovs) {
    pixels_.write(pixels);
    BatchParams params = common_params(film_settings_);
    params.pixels = static_cast<uint>(pixels.size());
    params.first_sample = first;
    params.samples = samples;
    return {params, pixels_, camera_, shutter_, camera_motion_, interior_, aovs};
}

void Renderer::render_batch(Film &film, const std::vector<uint> &pixels, uint first, uint samples, Aovs *aovs, WaveObserver *observer) {
    const Batch batch = batch_of(pixels, first, samples, aovs);
    integrator_->render(batch, samples_, observer);
    filter_.weigh(batch, samples_);
    filter_.weigh_splats(batch);
    film.add(batch, samples_, filter_.splats());
    if (aovs) aovs->add(batch, filter_);
    device_.finish();
}

std::vector<Sample> Renderer::render_pixel(Film &film, uint x, uint y, uint first, uint samples, WaveObserver *observer) {
    render_batch(film, {x | y << 16}, first, samples, nullptr, observer);
    return samples_.read(0, samples);
}

void Renderer::show(const std::vector<uint> &pixels, uint first, uint samples, WaveObserver &observer) {
    integrator_->render(batch_of(pixels, first, samples, nullptr), samples_, &observer);
    device_.finish();
}

}  // namespace brandung
