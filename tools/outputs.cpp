#include "tools/outputs.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>

#include "scene/image.h"
#include "scene/tone.h"
#include "tools/numbers.h"
#include "tools/provenance.h"
#include "tools/report.h"

namespace brandung {
namespace {

PictureStyle style_of(const OutputOptions &options, const FilmSettings &film) {
    PictureStyle style{.exposure = film.exposure, .tone = film.tone};
    const std::vector<std::string> &names = names_of_bits();
    for (const std::string &bits : options.bits) style.bits.push_back(static_cast<Bits>(std::find(names.begin(), names.end(), bits) - names.begin()));
    style.quality = options.quality.value_or(style.quality);
    return style;
}

/// Bits that no file can store are a mistake.
void check_bits(const OutputOptions &options, const PictureStyle &style) {
    for (std::size_t i = 0; i < style.bits.size(); ++i) {
        const auto stores = [&](const std::string &file) {
            const std::vector<Bits> possible = bits_of_format(file);
            return std::find(possible.begin(), possible.end(), style.bits[i]) != possible.end();
        };
        if (std::none_of(options.files.begin(), options.files.end(), stores))
            throw CLI::ValidationError("--bits", "no output's format stores '" + options.bits[i] + "'");
    }
}

std::string names(const nlohmann::json &list) {
    std::string text;
    for (const auto &each : list) text += (text.empty() ? "" : ", ") + each["name"].get<std::string>();
    return text;
}

std::map<std::string, std::string> metadata(const Job &job, const PhaseSeconds &seconds, const RenderEnd &end, bool running, float exposure) {
    std::map<std::string, std::string> metadata = {{"Software", program_version()},
                                                   {"brandung:scene", job.scene.file},
                                                   {"brandung:scene_hash", scene_fingerprint(job)},
                                                   {"brandung:spp", std::to_string(end.spp)},
                                                   {"brandung:exposure", fmt::format("{}", exposure)},
                                                   {"brandung:tone", tone_kinds()[job.scene.film.tone].name},
                                                   {"brandung:statistics", statistics(job, seconds, end).dump()}};
    for (const auto &[name, value] : settings_of(job)) metadata["brandung:" + name] = value;
    if (!job.distrust.empty()) metadata.insert({"brandung:distrust", job.distrust});
    if (end.noise)
        metadata.insert({{"brandung:noise", fmt::format("{:.6g}", end.noise->relmse)},
                         {"brandung:noise_confidence_95", fmt::format("{:.6g} {:.6g}", end.noise->low, end.noise->high)},
                         {"brandung:biased_by", names(biases(job))}});
    if (!end.complete())
        metadata.insert({{running ? "brandung:unfinished" : "brandung:interrupted", "true"}, {"brandung:samples", samples_taken(end)}});
    return metadata;
}

}  // namespace

std::string samples_taken(const RenderEnd &end) {
    return end.open_ended ? fmt::format("{} samples", end.samples_done) : fmt::format("{} of {} samples", end.samples_done, end.samples_total);
}

void add_output_options(CLI::App &command, OutputOptions &options) {
    command.option_defaults()->group("Output");
    command.add_option("-o,--output", options.files, "picture to write, its format by extension; several allowed")
        ->required()
        ->expected(1)
        ->take_all();
    command
        .add_option("--bits", options.bits,
                    "what pictures store: 8, 16, half or float; of several, as 16,half, each format takes the first that it has (default: float in "
                    "EXR, HDR and TIFF, else 8)")
        ->delimiter(',')
        ->expected(1)
        ->take_all()
        ->check(CLI::IsMember(names_of_bits()));
    command.add_option("--quality", options.quality, "of JPEG, 1 to 100 (default: 98)")->check(whole_numbers(1u, 100u));
    command.option_defaults()->group("Options");
}

void check_outputs(const OutputOptions &options, const FilmSettings &film) {
    const PictureStyle style = style_of(options, film);
    for (const std::string &file : options.files) check_picture_writable(file, film.window().width(), film.window().height(), style);
    check_bits(options, style);
    if (!film.aovs.empty() && std::none_of(options.files.begin(), options.files.end(), stores_channels))
        throw CLI::ValidationError("--aov", "no output is an EXR, which alone has channels for AOVs");
    if (options.quality && std::none_of(options.files.begin(), options.files.end(), is_jpeg))
        throw CLI::ValidationError("--quality", "no output is a JPEG");
}

OutputOptions numbered(OutputOptions options, uint number) {
    for (std::string &file : options.files) {
        const std::filesystem::path path(file);
        file = (path.parent_path() / fmt::format("{}_{:03}{}", path.stem().string(), number, path.extension().string())).string();
    }
    return options;
}

float write_outputs(const OutputOptions &options, Job &job, const PhaseSeconds &seconds, const RenderEnd &end, bool running) {
    const FilmSettings &film = job.scene.film;
    const Window window = film.window();
    PictureStyle style = style_of(options, film);
    Picture picture{window.width(), window.height(), job.film.develop(), {}};
    if (film.crop) picture.left = window.left, picture.top = window.top, picture.whole_width = film.width, picture.whole_height = film.height;
    if (job.aovs) picture.channels = job.aovs->develop(job.film);
    if (film.automatic_exposure) style.exposure = options.exposure ? *options.exposure : automatic_exposure(picture.pixels);
    if (std::any_of(options.files.begin(), options.files.end(), stores_metadata))
        picture.metadata = metadata(job, seconds, end, running, style.exposure);
    for (const std::string &file : options.files) write_picture(file, picture, style);
    return style.exposure;
}

}  // namespace brandung
