#include "tools/bench/report.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/error.h"
#include "tools/report.h"

namespace brandung {
namespace {

using nlohmann::json;

json kernel_json(const std::string &name, const KernelRuns &runs, const Limits &limits, uint batch, uint cores) {
    const double milliseconds = median(runs.milliseconds), seconds = milliseconds * 1e-3, items = static_cast<double>(runs.items);
    const auto [low, high] = std::minmax_element(runs.milliseconds.begin(), runs.milliseconds.end());
    const double bytes = static_cast<double>(runs.bytes) / seconds;
    return {{"name", name},
            {"launches", runs.launches},
            {"items", runs.items},
            {"milliseconds", milliseconds},
            {"milliseconds_low", *low},
            {"milliseconds_high", *high},
            {"items_per_second", items / seconds},
            {"ns_per_item_and_core", seconds * 1e9 * cores / items},
            {"bytes_per_item", static_cast<double>(runs.bytes) / items},
            {"bytes_per_second", bytes},
            {"share_of_copy", bytes / limits.copy_bytes_per_second},
            {"share_of_launching", std::min(static_cast<double>(runs.launches) * limits.launch_seconds / seconds, 1.0)},
            {"wave_occupancy", items / (static_cast<double>(runs.launches) * batch)}};
}

std::string line(const json &kernel, double whole) {
    return fmt::format("{:<26}{:>9}{:>13}{:>10.2f}{:>7.1f}{:>11.2f}{:>10.2f}{:>8.2f}{:>7.1f}{:>8.1f}{:>7.0f}\n", kernel["name"].get<std::string>(),
                       kernel["launches"].get<std::uint64_t>(), kernel["items"].get<std::uint64_t>(), kernel["milliseconds"].get<double>(),
                       100 * kernel["milliseconds"].get<double>() / whole, kernel["items_per_second"].get<double>() * 1e-6,
                       kernel["ns_per_item_and_core"].get<double>(), kernel["bytes_per_second"].get<double>() * 1e-9,
                       100 * kernel["share_of_copy"].get<double>(), 100 * kernel["share_of_launching"].get<double>(),
                       100 * kernel["wave_occupancy"].get<double>());
}

/// A number of an earlier result.
double number(const json &of, const char *name) {
    if (!of.is_object() || !of.contains(name) || !of[name].is_number())
        throw SceneError(fmt::format("--compare: \"{}\" is missing: is it of bench --json?", name));
    return of[name].get<double>();
}

/// How much slower the slowest run was than the fastest.
double spread(const json &kernel) { return number(kernel, "milliseconds_high") / number(kernel, "milliseconds_low") - 1; }

json change(const json &now, const json &before) {
    const double ns_now = number(now, "ns_per_item_and_core"), ns_before = number(before, "ns_per_item_and_core");
    return {{"name", now["name"]},      {"before", ns_before}, {"now", ns_now}, {"ratio", ns_now / ns_before}, {"spread_before", spread(before)},
            {"spread_now", spread(now)}};
}

}  // namespace

json bench_json(const Job &job, uint batch, const Measurements &measurements) {
    const FilmSettings &film = job.scene.film;
    const Limits &limits = measurements.limits;
    const double seconds = median(measurements.seconds);
    json all = {{"scene", job.scene.file},
                {"device", job.device.info().name},
                {"compute_units", job.device.info().compute_units},
                {"accelerator", job.compiled.accelerator},
                {"width", film.window().width()},
                {"height", film.window().height()},
                {"spp", film.spp},
                {"batch", batch},
                {"runs", measurements.seconds.size()},
                {"seconds", seconds},
                {"rays", ray_statistics(measurements.rays)},
                {"rays_per_second", static_cast<double>(measurements.rays.total()) / seconds},
                {"limits",
                 {{"copy_bytes_per_second", limits.copy_bytes_per_second},
                  {"flops_per_second", limits.flops_per_second},
                  {"flops_per_byte_at_the_ridge", limits.flops_per_second / limits.copy_bytes_per_second},
                  {"launch_seconds", limits.launch_seconds}}},
                {"kernels", json::array()}};
    for (const auto &[name, runs] : measurements.kernels)
        all["kernels"].push_back(kernel_json(name, runs, limits, batch, job.device.info().compute_units));
    std::sort(all["kernels"].begin(), all["kernels"].end(),
              [](const json &a, const json &b) { return a["milliseconds"].get<double>() > b["milliseconds"].get<double>(); });
    return all;
}

std::string bench_text(const json &bench) {
    const json &limits = bench["limits"];
    double whole = 0;
    for (const json &kernel : bench["kernels"]) whole += kernel["milliseconds"].get<double>();
    std::string text =
        fmt::format("{}, {} x {} pixels, {} spp, {} on {} ({} compute units); batches of {}, medians of {} runs\n", bench["scene"].get<std::string>(),
                    bench["width"].get<uint>(), bench["height"].get<uint>(), bench["spp"].get<uint>(), bench["accelerator"].get<std::string>(),
                    bench["device"].get<std::string>(), bench["compute_units"].get<uint>(), bench["batch"].get<uint>(), bench["runs"].get<uint>());
    text += fmt::format("render {:.3f} s, kernels {:.3f} s of it; {:.2f} M rays/s\n", bench["seconds"].get<double>(), whole * 1e-3,
                        bench["rays_per_second"].get<double>() * 1e-6);
    text += fmt::format(
        "the device's limits: copies {:.1f} GB/s, computes {:.0f} GFLOP/s (from {:.0f} operations per byte on), launches in {:.0f} us\n\n",
        limits["copy_bytes_per_second"].get<double>() * 1e-9, limits["flops_per_second"].get<double>() * 1e-9,
        limits["flops_per_byte_at_the_ridge"].get<double>(), limits["launch_seconds"].get<double>() * 1e6);
    text += "kernel                     launches        items        ms      %  M items/s   ns·core    GB/s  %copy %launch  %wave\n";
    for (const json &kernel : bench["kernels"]) text += line(kernel, whole);
    return text;
}

json comparison_json(const json &bench, const json &old) {
    json all = {{"seconds_before", number(old, "seconds")}, {"ratio", number(bench, "seconds") / number(old, "seconds")}, {"kernels", json::array()}};
    for (const json &kernel : bench["kernels"])
        for (const json &earlier : old["kernels"])
            if (earlier.is_object() && earlier.value("name", json()) == kernel["name"]) all["kernels"].push_back(change(kernel, earlier));
    return all;
}

std::string comparison_text(const json &bench) {
    const json &comparison = bench["comparison"];
    std::string text = "kernel                      ns·core before         now   ratio   spread of both\n";
    for (const json &kernel : comparison["kernels"])
        text +=
            fmt::format("{:<28}{:>14.2f}{:>12.2f}{:>8.3f}{:>9.0f} %{:>5.0f} %\n", kernel["name"].get<std::string>(), number(kernel, "before"),
                        number(kernel, "now"), number(kernel, "ratio"), 100 * number(kernel, "spread_before"), 100 * number(kernel, "spread_now"));
    return text + fmt::format("{:<28}{:>12.3f} s{:>10.3f} s{:>8.3f}\n", "render", number(comparison, "seconds_before"), number(bench, "seconds"),
                              number(comparison, "ratio"));
}

}  // namespace brandung
