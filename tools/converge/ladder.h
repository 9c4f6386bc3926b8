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
/// Every combination of the values of all keys, each "KEY=VALUE,VALUE,...", where commas within brackets or quotation marks part no values; one
/// without a change where there are none. Names have the last parts of keys, or all where those are the same. Throws CLI::ValidationError.
std::vector<Variant> variants(const std::vector<std::string> &varied);

/// How much each rung renders: samples per pixel, or seconds.
struct Rungs {
    std::vector<uint> samples;
    std::vector<double> seconds;
    std::size_t count() const { return samples.empty() ? seconds.size() : samples.size(); }
};

/// The `index`-th seed from `first` on, passing over the one that is taken: no two pictures of a ladder share random numbers, nor any with the
/// reference. Every way has the same seed on the same rung and repetition (common random numbers).
inline uint seed_at(uint first, uint index, std::optional<uint> taken) {
    const uint seed = first + index;
    return taken && index >= *taken - first ? seed + 1 : seed;
}

/// A scene in one way, to be rendered again and again.
class Climber {
public:
    /// Reads the scene.
    Climber(SceneOptions options, const Variant &variant);
    /// Takes the device and builds kernels; before anything but the scene is asked for.
    void prepare();

    /// With what has biased its pictures so far.
    const Way &way() const { return way_; }
    const std::string &name() const { return way_.name; }
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
    SceneOptions options_;
    Scene scene_;
    std::optional<Job> job_;
    Way way_;
};

}  // namespace brandung
