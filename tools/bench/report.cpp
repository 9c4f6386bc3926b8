#include "tools/bench/report.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/accelerators/accelerator.h"
#include "tools/median.h"
#include "tools/provenance.h"
#include "tools/report.h"

namespace brandung {
namespace {

using nlohmann::json;

json kernel_json(const std::string &name, const KernelRuns &runs, const Limits &limits, uint cores) {
    const double milliseconds = median(runs.milliseconds), seconds = milliseconds * 1e-3, items = static_cast<double>(runs.items);
    const double waiting = median(runs.waiting_milliseconds);
    const auto [low, high] = std::minmax_element(runs.milliseconds.begin(), runs.milliseconds.end());
    json kernel = {{"name", name},
                   {"launches", runs.launches},
                   {"items", runs.items},
                   {"milliseconds", milliseconds},
                   {"milliseconds_low", *low},
                   {"milliseconds_high", *high},
                   {"items_per_second", items / seconds},
                   {"ns_per_item_and_core", seconds * 1e9 * cores / items},
                   {"bytes_per_item", nullptr},
                   {"bytes_per_second", nullptr},
                   {"share_of_copy", nullptr},
                   {"launching_milliseconds", waiting},
                   {"share_of_launching", waiting / (waiting + milliseconds)},
                   {"wave_occupancy", nullptr}};
    if (runs.bytes) {
        kernel["bytes_per_item"] = *runs.bytes / items;
        kernel["bytes_per_second"] = *runs.bytes / seconds;
        kernel["share_of_copy"] = *runs.bytes / seconds / limits.copy_bytes_per_second;
    }
    if (runs.capacity > 0) kernel["wave_occupancy"] = items / runs.capacity;
    return kernel;
}

/// Medians over the runs of what they spent: kernels at work, the device free with one queued, and the rest: the host, transfers, fills.
json parts_of_seconds(const Measurements &measurements) {
    std::vector<double> running, launching, rest;
    for (std::size_t run = 0; run < measurements.seconds.size(); ++run) {
        running.push_back(0), launching.push_back(0);
        for (const auto &[name, runs] : measurements.kernels)
            running.back() += runs.milliseconds.at(run) * 1e-3, launching.back() += runs.waiting_milliseconds.at(run) * 1e-3;
        rest.push_back(measurements.seconds[run] - running.back() - launching.back());
    }
    return {{"running", median(running)}, {"launching", median(launching)}, {"rest", median(rest)}};
}

/// A number with so many digits behind its point, or a dash for null.
std::string cell(const json &value, double factor, int digits) {
    return value.is_null() ? "-" : fmt::format("{:.{}f}", factor * value.get<double>(), digits);
}

std::string line(const json &kernel, double whole) {
    return fmt::format("{:<26}{:>9}{:>13}{:>10.2f}{:>7.1f}{:>11.2f}{:>10.2f}{:>8}{:>8}{:>7}{:>9.1f}{:>7}\n", kernel["name"].get<std::string>(),
                       kernel["launches"].get<std::uint64_t>(), kernel["items"].get<std::uint64_t>(), kernel["milliseconds"].get<double>(),
                       100 * kernel["milliseconds"].get<double>() / whole, kernel["items_per_second"].get<double>() * 1e-6,
                       kernel["ns_per_item_and_core"].get<double>(), cell(kernel["bytes_per_item"], 1, 1), cell(kernel["bytes_per_second"], 1e-9, 2),
                       cell(kernel["share_of_copy"], 100, 1), 100 * kernel["share_of_launching"].get<double>(),
                       cell(kernel["wave_occupancy"], 100, 0));
}

}  // namespace

json bench_subject(const Job &job, uint batch) {
    const FilmSettings &film = job.scene.film;
    const Window window = film.window();
    json settings = settings_of(job);
    settings["spp"] = std::to_string(film.spp);
    return {{"scene", job.scene.file},
            {"scene_hash", scene_fingerprint(job)},
            {"settings", settings},
            {"program", program_version()},
            {"device", job.device.info().name},
            {"driver", job.device.info().driver},
            {"compute_units", job.device.info().compute_units},
            {"accelerator", job.compiled.accelerator->name},
            {"width", window.width()},
            {"height", window.height()},
            {"spp", film.spp},
            {"batch", batch}};
}

json bench_json(const Job &job, uint batch, const Measurements &measurements) {
    const Limits &limits = measurements.limits;
    const double seconds = median(measurements.seconds);
    json all = bench_subject(job, batch);
    all.update({{"runs", measurements.seconds.size()},
                {"runs_total", measurements.runs_total},
                {"interrupted", measurements.interrupted()},
                {"seconds", seconds},
                {"parts_of_seconds", parts_of_seconds(measurements)},
                {"rays", ray_statistics(measurements.rays)},
                {"rays_per_second", static_cast<double>(measurements.rays.total()) / seconds},
                {"limits",
                 {{"copy_bytes_per_second", limits.copy_bytes_per_second},
                  {"flops_per_second", limits.flops_per_second},
                  {"flops_per_byte_at_the_ridge", limits.flops_per_second / limits.copy_bytes_per_second},
                  {"launch_seconds", limits.launch_seconds}}},
                {"kernels", json::array()}});
    for (const auto &[name, runs] : measurements.kernels) all["kernels"].push_back(kernel_json(name, runs, limits, job.device.info().compute_units));
    std::sort(all["kernels"].begin(), all["kernels"].end(),
              [](const json &a, const json &b) { return a["milliseconds"].get<double>() > b["milliseconds"].get<double>(); });
    return all;
}

std::string bench_text(const json &bench) {
    const json &limits = bench["limits"], &parts = bench["parts_of_seconds"];
    double whole = 0;
    for (const json &kernel : bench["kernels"]) whole += kernel["milliseconds"].get<double>();
    std::string text =
        fmt::format("{}, {} x {} pixels, {} spp, {} on {} ({} compute units); batches of {}, medians of {} runs\n", bench["scene"].get<std::string>(),
                    bench["width"].get<uint>(), bench["height"].get<uint>(), bench["spp"].get<uint>(), bench["accelerator"].get<std::string>(),
                    bench["device"].get<std::string>(), bench["compute_units"].get<uint>(), bench["batch"].get<uint>(), bench["runs"].get<uint>());
    text += fmt::format("render {:.3f} s: kernels {:.3f} s, launching them {:.3f} s, the rest (host, transfers, fills) {:.3f} s; {:.2f} M rays/s\n",
                        bench["seconds"].get<double>(), parts["running"].get<double>(), parts["launching"].get<double>(), parts["rest"].get<double>(),
                        bench["rays_per_second"].get<double>() * 1e-6);
    text += fmt::format(
        "the device's limits: copies {:.1f} GB/s, computes {:.0f} GFLOP/s (from {:.0f} operations per byte on), an empty launch and back {:.0f} us\n",
        limits["copy_bytes_per_second"].get<double>() * 1e-9, limits["flops_per_second"].get<double>() * 1e-9,
        limits["flops_per_byte_at_the_ridge"].get<double>(), limits["launch_seconds"].get<double>() * 1e6);
    if (bench["interrupted"].get<bool>())
        text += fmt::format("interrupted: {} of {} runs\n", bench["runs"].get<uint>(), bench["runs_total"].get<uint>());
    text += "kernels' operations are not counted, nor bytes (-) where they depend on what a kernel finds\n\n";
    text += "kernel                     launches        items        ms      %  M items/s   ns·core  B/item    GB/s  %copy  %launch  %wave\n";
    for (const json &kernel : bench["kernels"]) text += line(kernel, whole);
    return text;
}

}  // namespace brandung
