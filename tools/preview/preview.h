/// Preview: tells viewers how a render is getting on. It looks between batches, and so rarely that the render hardly notices.
#pragma once
#include <deque>
#include <functional>

#include "tools/job.h"
#include "tools/pace.h"
#include "tools/preview/target.h"
#include "tools/preview/viewer.h"

namespace brandung {

class WebViewer;

class Preview {
public:
    /// Opens all viewers: `name` is the picture's. Throws SceneError if one cannot be opened.
    Preview(const std::vector<PreviewTarget> &targets, const Scene &scene, const std::string &name, uint batch);
    ~Preview();

    bool active() const { return !viewers_.empty(); }
    /// Of the web pages, by their order in `targets`.
    std::vector<std::string> urls() const;

    /// What is being prepared.
    void say(const std::string &what);
    /// The integrator's loop has come to a step.
    void add_step(const WaveStep &step);
    /// What is known once everything is prepared.
    void begin(const Job &job);
    void after_batch(const RenderProgress &progress, Job &job);
    void finish(const RenderEnd &end, Job &job);
    /// Why viewers have gone away, each told once.
    std::vector<std::string> take_faults();
    /// Waits until viewers have what was shown last, and goes on serving pages for so many seconds or until `stop`; if nothing is said, until pages
    /// that are open have seen the end.
    void hold(std::optional<double> seconds, const std::function<bool()> &stop) const;

private:
    bool somebody_wants_picture() const;
    void update_counts(const Job &job);
    void take_picture(Film &film);
    void show();

    std::vector<std::unique_ptr<PreviewViewer>> viewers_;
    std::vector<const WebViewer *> web_;  ///< those of `viewers_` that are pages
    PreviewState state_;
    bool automatic_exposure_ = false;
    Pace pace_;
    std::deque<WaveStep> steps_;
    double next_state_ = 0, next_picture_ = 0;  ///< no earlier than these [s]
};

}  // namespace brandung
