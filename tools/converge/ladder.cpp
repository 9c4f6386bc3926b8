#include "tools/converge/ladder.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "tools/provenance.h"

namespace brandung {
namespace {

/// At commas, but for those within brackets or quotation marks.
std::vector<std::string> split(const std::string &text) {
    std::vector<std::string> parts(1);
    int depth = 0;
    bool quoted = false;
    for (const char c : text) {
        quoted ^= c == '"';
        if (!quoted) depth += (c == '[' || c == '{') - (c == ']' || c == '}');
        if (c == ',' && depth == 0 && !quoted)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

std::string last_part(const std::string &key) { return key.substr(key.find_last_of('.') + 1); }

/// The key as names of series have it: the shortest that tells it from the others.
std::string short_key(const std::string &key, const std::vector<std::string> &varied) {
    const auto has_same_end = [&](const std::string &text) { return last_part(text.substr(0, text.find('='))) == last_part(key); };
    return std::count_if(varied.begin(), varied.end(), has_same_end) > 1 ? key : last_part(key);
}

Scene read_variant(SceneOptions &options, const Variant &variant) {
    options.varied = variant.settings;
    options.varied.push_back("film.pixel=random");
    return read_scene(options);
}

}  // namespace

std::vector<Variant> variants(const std::vector<std::string> &varied) {
    std::vector<Variant> all = {{"", {}}};
    for (const std::string &text : varied) {
        const auto equals = text.find('=');
        if (equals == std::string::npos || equals == 0) throw CLI::ValidationError("--vary", "expected KEY=VALUE,VALUE,..., got '" + text + "'");
        const std::string key = text.substr(0, equals);
        if (std::count_if(varied.begin(), varied.end(), [&](const std::string &other) { return other.starts_with(key + "="); }) > 1)
            throw CLI::ValidationError("--vary", key + " is varied twice");
        std::vector<Variant> more;
        for (const Variant &variant : all)
            for (const std::string &value : split(text.substr(equals + 1))) {
                if (value.empty()) throw CLI::ValidationError("--vary", "an empty value in '" + text + "'");
                Variant &next = more.emplace_back(variant);
                next.name += (next.name.empty() ? "" : ", ") + short_key(key, varied) + "=" + value;
                next.settings.push_back(key + "=" + value);
            }
        all = std::move(more);
    }
    if (varied.empty()) all.front().name = "brandung";
    return all;
}

Climber::Climber(SceneOptions options, const Variant &variant)
    : options_(std::move(options)), scene_(read_variant(options_, variant)), way_{variant.name, {}, {}} {}

void Climber::prepare() {
    job_.emplace(scene_, options_);
    way_.settings = settings_of(*job_);
    way_.settings["scene_hash"] = scene_fingerprint(*job_);
    way_.transmits = job_->compiled.transmits;
}

Climber::Result Climber::render(uint samples, uint seed, const StopRules &stop, const std::function<bool(const RenderProgress &)> &observe) {
    scene_.film.spp = samples, scene_.film.seed = seed;
    job_->film.clear();
    Renderer renderer(job_->device, scene_, job_->compiled, job_->on_device, job_->camera, {.batch = options_.batch, .on_step = {}, .stop = stop});
    double seconds = 0;
    const RenderEnd end = timed(seconds, [&] { return renderer.render(job_->film, {{0.2, observe}}); });
    if (!end.failure.empty()) throw Error(end.failure);
    for (const Bias &bias : renderer.integrator().biases()) way_.biased_by[bias.name] = bias.why;
    const Window window = scene_.film.window();
    return {{window.width(), window.height(), job_->film.develop(), {}},
            static_cast<double>(end.samples_done) / static_cast<double>(window.pixels()),
            seconds,
            end.noise};
}

}  // namespace brandung
