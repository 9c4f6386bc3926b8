#include "tools/converge/ladder.h"

#include <CLI/CLI.hpp>

namespace brandung {
namespace {

std::vector<std::string> split(const std::string &text, char separator) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1)
        parts.push_back(text.substr(begin, (end = text.find(separator, begin)) - begin));
    return parts;
}

Scene read_variant(SceneOptions &options, const Variant &variant) {
    options.settings.insert(options.settings.end(), variant.settings.begin(), variant.settings.end());
    options.settings.push_back("film.pixel=random");
    return read_scene(options);
}

}  // namespace

std::vector<Variant> variants(const std::vector<std::string> &varied) {
    std::vector<Variant> all = {{"", {}}};
    for (const std::string &text : varied) {
        const auto equals = text.find('=');
        if (equals == std::string::npos || equals == 0) throw CLI::ValidationError("--vary", "expected KEY=VALUE,VALUE,..., got '" + text + "'");
        const std::string key = text.substr(0, equals);
        std::vector<Variant> more;
        for (const Variant &variant : all)
            for (const std::string &value : split(text.substr(equals + 1), ',')) {
                if (value.empty()) throw CLI::ValidationError("--vary", "an empty value in '" + text + "'");
                Variant &next = more.emplace_back(variant);
                next.name += (next.name.empty() ? "" : ", ") + value;
                next.settings.push_back(key + "=" + value);
            }
        all = std::move(more);
    }
    if (varied.empty()) all.front().name = "brandung";
    return all;
}

Climber::Climber(SceneOptions options, const Variant &variant)
    : name_(variant.name), options_(std::move(options)), scene_(read_variant(options_, variant)) {
    job_.emplace(scene_, options_);
}

Climber::Result Climber::render(uint samples, uint seed, const StopRules &stop, const std::function<bool(const RenderProgress &)> &observe) {
    scene_.film.spp = samples, scene_.film.seed = seed;
    job_->film.clear();
    Renderer renderer(job_->device, scene_, job_->compiled, job_->on_device, job_->camera, {.batch = options_.batch, .on_step = {}, .stop = stop});
    double seconds = 0;
    const RenderEnd end = timed(seconds, [&] { return renderer.render(job_->film, {{0.2, observe}}); });
    if (!end.failure.empty()) throw Error(end.failure);
    const Window window = scene_.film.window();
    return {{window.width(), window.height(), job_->film.develop(), {}},
            static_cast<double>(end.samples_done) / static_cast<double>(window.pixels()),
            seconds,
            end.noise};
}

}  // namespace brandung
