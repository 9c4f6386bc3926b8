#include "runtime/renderer.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "runtime/wavefront/work.h"
#include "scene/error.h"

namespace brandung {
namespace {

/// Samples of one pixel that one batch takes, the first `done` being done: few, so that an interrupted picture is whole, if noisier, and of many just
/// one at first, so that there is a whole picture soon; but more where the whole picture is in every batch anyway.
uint samples_at_once(const FilmSettings &film, uint batch, uint done) {
    const std::uint64_t few = 16, pass = done == 0 && film.spp > few ? 1 : few, pixels = film.window().pixels();
    return static_cast<uint>(std::min<std::uint64_t>({film.spp - done, batch, std::max(pass, batch / pixels)}));
}

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

/// Tells observers of a render that begins now.
class Announcement {
public:
    explicit Announcement(const std::vector<Observer> &observers) : observers_(observers), told_(observers.size()) {}

    /// Those whose time has come, and what time it is; false if one of them stops the render.
    bool tell(RenderProgress &progress) {
        progress.seconds = seconds();
        bool goes_on = true;
        for (std::size_t i = 0; i < observers_.size(); ++i) {
            if (progress.seconds - told_[i] < observers_[i].seconds) continue;
            if (!observers_[i].observe(progress)) goes_on = false;
            told_[i] = seconds();
        }
        return goes_on;
    }

private:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

    const std::vector<Observer> &observers_;
    std::vector<double> told_;  ///< when the calls ended
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

Camera make_camera(const CameraDescription &description, uint width, uint height) {
    const glm::dvec3 forward = glm::normalize(glm::dvec3(description.at) - glm::dvec3(description.from));
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(description.up)));
    const glm::dvec3 up = glm::cross(right, forward);
    const double half_height = std::tan(0.5 * static_cast<double>(description.fov)), half_width = half_height * width / height;
    return {.position = description.from,
            .corner = vec3(forward - half_width * right + half_height * up),
            .right = vec3(2 * half_width * right),
            .down = vec3(-2 * half_height * up),
            .width = width,
            .height = height};
}

Renderer::Renderer(Device &device, const Scene &scene, const CompiledScene &compiled, const DeviceScene &on_device, const CameraDescription &camera,
                   RenderOptions options)
    : device_(device),
      film_settings_(checked(scene)),
      options_(std::move(options)),
      camera_(make_camera(camera, film_settings_.width, film_settings_.height)),
      interior_(media_of_eye(scene, compiled, camera)),
      filter_(device, film_settings_, on_device.lists()),
      integrator_(integrator_of(scene).make({device, scene, compiled, on_device, filter_, options_.batch, options_.on_step})),
      pixels_(device, options_.batch),
      samples_(device, options_.batch) {}

std::size_t Renderer::wave_bytes() const { return integrator_->wave_bytes() + filter_.bytes() + pixels_.bytes() + samples_.bytes(); }

RenderEnd Renderer::render(Film &film, const std::vector<Observer> &observers, Aovs *aovs) {
    RenderProgress progress{0, film.window().pixels() * film_settings_.spp, 0};
    try {
        const bool complete = render_batches(film, progress, observers, aovs);
        return {complete, "", progress.samples_done, progress.samples_total};
    } catch (const Error &error) {
        if (progress.samples_done == 0) throw;
        return {false, error.what(), progress.samples_done, progress.samples_total};
    }
}

/// False if stopped before the end.
bool Renderer::render_batches(Film &film, RenderProgress &progress, const std::vector<Observer> &observers, Aovs *aovs) {
    Announcement announcement(observers);
    const uint spp = film_settings_.spp;
    for (uint first = 0, samples = 0; first < spp; first += samples) {
        samples = samples_at_once(film_settings_, options_.batch, first);
        const uint pixels_at_once = options_.batch / samples;
        PixelOrder order(film.window());
        for (auto pixels = order.next(pixels_at_once); !pixels.empty(); pixels = order.next(pixels_at_once)) {
            render_batch(film, pixels, first, samples, aovs, nullptr);
            progress.samples_done += pixels.size() * samples;
            if (!announcement.tell(progress)) return progress.samples_done == progress.samples_total;
        }
    }
    return true;
}

/// The pixels' samples first ... first + samples.
void Renderer::render_batch(Film &film, const std::vector<uint> &pixels, uint first, uint samples, Aovs *aovs, WaveObserver *observer) {
    pixels_.write(pixels);
    BatchParams params = common_params(film_settings_);
    params.pixels = static_cast<uint>(pixels.size());
    params.first_sample = first;
    params.samples = samples;
    const Batch batch{params, pixels_, camera_, interior_, aovs};
    integrator_->render(batch, samples_, observer);
    filter_.weigh(batch, samples_);
    film.add(batch, samples_);
    if (aovs) aovs->add(batch, filter_);
    device_.finish();
}

std::vector<Sample> Renderer::render_pixel(Film &film, uint x, uint y, uint first, uint samples, WaveObserver *observer) {
    render_batch(film, {x | y << 16}, first, samples, nullptr, observer);
    return samples_.read(0, samples);
}

}  // namespace brandung
