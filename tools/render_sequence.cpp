#include "tools/render_sequence.h"

#include <fmt/core.h>

#include <numbers>

#include "runtime/opencl/seconds_now.h"
#include "scene/error.h"
#include "tools/interruption.h"
#include "tools/render_messages.h"

namespace brandung {
namespace {

/// Progress of a picture as a part of them all.
class Sequence {
public:
    explicit Sequence(uint pictures) : pictures_(pictures) {}
    RenderProgress whole(const RenderProgress &of_picture) const {
        RenderProgress all = of_picture;
        all.samples_done += samples_, all.samples_total = samples_ + (pictures_ - done_) * of_picture.samples_total;
        all.seconds = seconds_now() - start_;
        all.part = (static_cast<double>(done_) + of_picture.part) / static_cast<double>(pictures_);
        if (done_ + 1 < pictures_) all.seconds_left.reset();
        return all;
    }
    void end_picture(const RenderEnd &end) { ++done_, samples_ += end.samples_done; }

private:
    std::uint64_t pictures_, done_ = 0, samples_ = 0;
    double start_ = seconds_now();
};

RenderEnd unfinished(const RenderProgress &done) {
    return {.stopped_by = StoppedBy::observer,
            .failure = "",
            .samples_done = done.samples_done,
            .samples_total = done.samples_total,
            .open_ended = done.open_ended,
            .noise = done.noise,
            .spp = done.spp};
}

/// The sequence so far with one more picture; its noise is that of the noisiest.
RenderEnd joined(const RenderEnd &all, const RenderEnd &picture, uint pictures_left) {
    RenderEnd end = picture;
    end.samples_done += all.samples_done, end.samples_total = all.samples_done + pictures_left * picture.samples_total;
    if (all.noise && (!end.noise || all.noise->relmse > end.noise->relmse)) end.noise = all.noise;
    return end;
}

/// Writes the pictures so far now and then, but not the last, which are written anyway; where that fails the render goes on.
Observer saving(double every, const OutputOptions &outputs, Job &job, PhaseSeconds seconds, ProgressLine &progress) {
    return {every, [&, outputs, seconds](const RenderProgress &done) mutable {
                if (done.samples_done == done.samples_total) return true;
                seconds.render = done.seconds;
                try {
                    write_outputs(outputs, job, seconds, unfinished(done), true);
                } catch (const SceneError &error) {
                    progress.clear();
                    fmt::print(stderr, "warning: {}\n", error.what());
                }
                return true;
            }};
}

/// Who is told of every picture alike.
std::vector<Observer> observers_of_all(const Sequence &sequence, Job &job, Preview &preview, Trace *trace, ProgressLine &progress) {
    std::vector<Observer> observers = {{0, [&](const RenderProgress &of_picture) {
                                            progress.show(sequence.whole(of_picture));
                                            return !is_interrupted();
                                        }}};
    if (preview.active())
        observers.push_back({0, [&](const RenderProgress &of_picture) {
                                 preview.after_batch(sequence.whole(of_picture), job);
                                 print_faults(preview, progress);
                                 return true;
                             }});
    if (trace)
        observers.push_back({0, [&job, trace](const RenderProgress &) {
                                 trace->add(job.renderer.integrator().counts());
                                 return true;
                             }});
    return observers;
}

}  // namespace

std::pair<RenderEnd, float> render_pictures(const RenderCommandOptions &options, Job &job, PhaseSeconds &seconds, Preview &preview, Trace *trace,
                                            ProgressLine &progress) {
    Sequence sequence(options.pictures());
    const std::vector<Observer> of_all = observers_of_all(sequence, job, preview, trace, progress);
    RenderEnd all;
    std::optional<float> exposure;
    double write_seconds = 0;
    for (uint picture = 0; picture < options.pictures() && all.complete(); ++picture) {
        OutputOptions outputs = options.outputs_of(picture);
        outputs.exposure = exposure;
        if (picture > 0) {
            job.turn(2 * std::numbers::pi * picture / options.pictures());
            job.film.clear();
        }
        std::vector<Observer> observers = of_all;
        if (options.save_every) observers.push_back(saving(*options.save_every, outputs, job, seconds, progress));
        const RenderEnd end = timed(seconds.render, [&] { return job.renderer.render(job.film, observers, job.aovs ? &*job.aovs : nullptr); });
        sequence.end_picture(end);
        progress.clear();
        exposure = timed(write_seconds, [&] { return write_outputs(outputs, job, seconds, end, false); });
        const std::string prefix = options.pictures() > 1 ? outputs.files.front() + ": " : "";
        if (!options.quiet) print_noise(job, end, prefix);
        print_missed_error(end, options.stop, prefix);
        all = joined(all, end, options.pictures() - picture);
    }
    seconds.write = write_seconds;
    return {all, exposure.value()};
}

}  // namespace brandung
