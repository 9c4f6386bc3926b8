/// Ladder: one scene, rendered in several ways, with more and more samples or time.
#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "tools/converge/series.h"
#include "tools/job.h"

namespace brandung {

/// A way of rendering: settings of the scene file that are changed, as "KEY=VALUE".
struct Variant {
    std::string name;
    std::vector<std::string> settings;
};
/// Every combination of the values of all keys, each "KEY=VALUE,VALUE,..."; one without a change where there are none. Throws CLI::ValidationError.
std::vector<Variant> variants(const std::vector<std::string> &varied);

/// How much each rung renders: samples per pixel, or seconds.
struct Rungs {
    std::vector<uint> samples;
    std::vector<double> seconds;
    std::size_t count() const { return samples.empty() ? seconds.size() : samples.size(); }
};

/// A scene in one way, ready to be rendered again and again.
class Climber {
public:
    Climber(SceneOptions options, const Variant &variant);

    const std::string &name() const { return name_; }
    const Job &job() const { return *job_; }
    const Scene &scene() const { return scene_; }
    /// Renders so many samples, or for so long; a single sample lies anywhere in its pixel too.
    struct Result {
        Picture picture;
        double samples, seconds;
        std::optional<Noise> noise;
    };
    Result render(uint samples, uint seed, const StopRules &stop, const std::function<bool(const RenderProgress &)> &observe);

private:
    std::string name_;
    SceneOptions options_;
    Scene scene_;
    std::optional<Job> job_;
};

}  // namespace brandung
