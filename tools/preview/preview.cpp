#include "tools/preview/preview.h"

#include <algorithm>
#include <thread>

#include "runtime/opencl/seconds_now.h"
#include "scene/accelerators/accelerator.h"
#include "scene/filters/filter.h"
#include "scene/tone.h"
#include "tools/preview/tev.h"
#include "tools/preview/web.h"

namespace brandung {
namespace {

constexpr std::size_t steps_kept = 240;
constexpr double seconds_between_states = 0.2, seconds_between_pictures = 0.5;
/// The part of a render's time that may go into pictures for viewers is one in so many.
constexpr double pictures_share = 100;
/// A page asks twice a second.
constexpr double seconds_to_see_the_end = 2;

}  // namespace

Preview::Preview(const std::vector<PreviewTarget> &targets, const Scene &scene, const std::string &name, uint batch) {
    const FilmSettings &film = scene.film;
    const uint width = film.window().width(), height = film.window().height();
    automatic_exposure_ = film.automatic_exposure;
    state_.subject = {scene.file, scene.integrator.type, "", "", width, height, film.spp, batch, {.exposure = film.exposure, .tone = film.tone}};
    state_.progress.samples_total = sampled_window(film).pixels() * film.spp;
    for (const PreviewTarget &target : targets) {
        if (target.kind == PreviewTarget::tev) {
            viewers_.push_back(std::make_unique<TevViewer>(target, name, width, height));
        } else {
            auto web = std::make_unique<WebViewer>(target.port);
            web_.push_back(web.get());
            viewers_.push_back(std::move(web));
        }
    }
    show();
}

Preview::~Preview() = default;

std::vector<std::string> Preview::urls() const {
    std::vector<std::string> urls;
    for (const WebViewer *web : web_) urls.push_back(web->url());
    return urls;
}

void Preview::say(const std::string &what) {
    state_.doing = what;
    show();
}

void Preview::add_step(const WaveStep &step) {
    steps_.push_back(step);
    if (steps_.size() > steps_kept) steps_.pop_front();
}

void Preview::begin(const Job &job) {
    state_.subject.accelerator = job.compiled.accelerator->name;
    state_.subject.device = job.device.info().name;
    show();
}

void Preview::after_batch(const RenderProgress &progress, Job &job) {
    pace_.add(progress);
    state_.progress = progress;
    const double now = seconds_now();
    const bool picture = now >= next_picture_ && somebody_wants_picture();
    if (!picture && now < next_state_) return;
    next_state_ = now + seconds_between_states;
    state_.phase = PreviewPhase::rendering;
    state_.doing.clear();
    update_counts(job);
    if (picture) take_picture(job.film);
    show();
}

void Preview::finish(const RenderEnd &end, Job &job) {
    if (!active()) return;
    state_.phase = end.complete() ? PreviewPhase::done : end.failure.empty() ? PreviewPhase::interrupted : PreviewPhase::failed;
    state_.doing = end.failure;
    state_.progress.noise = end.noise;
    if (end.complete()) state_.progress.part = 1;
    update_counts(job);
    state_.seconds_left.reset();
    take_picture(job.film);
    show();
}

std::vector<std::string> Preview::take_faults() {
    std::vector<std::string> faults;
    for (const auto &viewer : viewers_)
        if (auto fault = viewer->take_fault()) faults.push_back(std::move(*fault));
    return faults;
}

void Preview::hold(std::optional<double> seconds, const std::function<bool()> &stop) const {
    for (const auto &viewer : viewers_) viewer->flush();
    const bool watched = std::any_of(web_.begin(), web_.end(), [](const WebViewer *web) { return web->watched(); });
    const double end = seconds_now() + seconds.value_or(watched ? seconds_to_see_the_end : 0);
    while (seconds_now() < end && !stop()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
}

bool Preview::somebody_wants_picture() const {
    return std::any_of(viewers_.begin(), viewers_.end(), [](const auto &viewer) { return viewer->wants_picture(); });
}

void Preview::update_counts(const Job &job) {
    state_.samples_per_second = pace_.samples_per_second();
    state_.seconds_left = pace_.seconds_left();
    state_.rays = job.renderer.integrator().counts();
    const double rays_per_sample = static_cast<double>(state_.rays.total()) / static_cast<double>(state_.progress.samples_done);
    if (state_.samples_per_second) state_.rays_per_second = *state_.samples_per_second * rays_per_sample;
    state_.kernels = job.device.profile();
    state_.steps.assign(steps_.begin(), steps_.end());
}

void Preview::take_picture(Film &film) {
    double cost = 0;
    timed(cost, [&] { state_.picture = std::make_shared<Picture>(Picture{film.window().width(), film.window().height(), film.develop(), {}}); });
    if (automatic_exposure_) state_.subject.style.exposure = automatic_exposure(state_.picture->pixels);
    next_picture_ = seconds_now() + std::max(seconds_between_pictures, cost * pictures_share);
}

void Preview::show() {
    if (!active()) return;
    const auto state = std::make_shared<const PreviewState>(state_);
    for (const auto &viewer : viewers_) viewer->show(state);
}

}  // namespace brandung
