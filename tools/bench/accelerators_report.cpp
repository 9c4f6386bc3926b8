#include "tools/bench/accelerators_report.h"

#include <fmt/format.h>

#include "tools/median.h"

namespace brandung {
namespace {

using nlohmann::json;

/// N_IT, N_TS, N_ETS and N_EETS are Havran's and Sixta's (see kernels/accelerators/work.h): per ray. Of structures that list
/// primitives in cells N_IT is what they would test without mailboxes, of others what they do test.
json work_json(const WorkSums &work) {
    const auto per_ray = [&](std::uint64_t sum) { return work.rays == 0 ? json() : json(double(sum) / double(work.rays)); };
    json all = {{"rays", work.rays},
                {"hits", work.hits},
                {"N_IT", per_ray(work.listed > 0 ? work.listed : work.tests)},
                {"N_TS", per_ray(work.steps)},
                {"N_ETS", per_ray(work.cells)},
                {"N_EETS", per_ray(work.empty_cells)},
                {"tests", per_ray(work.tests)},
                {"tests_made", per_ray(BLOCK_SIZE * work.blocks)}};
    if (work.missed + work.idle + work.served > 0)
        all.update({{"missed_volumes", per_ray(work.missed)}, {"idle_volumes", per_ray(work.idle)}, {"served_volumes", per_ray(work.served)}});
    return all;
}

json use_json(const UseOfRays &use) {
    json all = work_json(use.work);
    all["different"] = use.different;
    all["seconds"] = use.seconds.empty() ? json() : json(median(use.seconds));
    all["rays_per_second"] = use.seconds.empty() ? json() : json(double(use.work.rays) / median(use.seconds));
    return all;
}

/// The sums over a render's rays, of all uses that were measured.
json all_json(const AcceleratorRow &row) {
    WorkSums work;
    for (std::size_t use = 0; use < ray_uses; ++use)
        if (use != std::size_t(RayQueue::Use::random)) work.add(row.uses[use].work);
    return work_json(work);
}

double trace_seconds(const AcceleratorRow &row) {
    double sum = 0;
    for (const UseOfRays &use : row.uses) sum += use.seconds.empty() ? 0 : median(use.seconds);
    return sum;
}

std::string cell(const json &value, double factor, int width, int digits) {
    return value.is_null() ? fmt::format("{:>{}}", "-", width) : fmt::format("{:>{}.{}f}", factor * value.get<double>(), width, digits);
}

std::string line(const json &row, int of_scene) {
    std::string text =
        fmt::format("{:<{}}{:<16}{:>8}{:>9.4f}{:>8.1f}{:>8.1f}", row["scene"].get<std::string>(), of_scene, row["accelerator"].get<std::string>(),
                    row["packets"].get<bool>() ? "yes" : "no", row["build_seconds"].get<double>(), row["node_bytes_per_primitive"].get<double>(),
                    row["block_bytes_per_primitive"].get<double>());
    for (const char *use : {"camera", "secondary", "shadow"}) {
        const json &rays = row["rays"][use];
        text += " " + cell(rays["tests"], 1, 9, 2) + cell(rays["N_TS"], 1, 8, 2) + cell(rays["rays_per_second"], 1e-6, 8, 3);
    }
    return text + fmt::format("{:>10.3f}{:>10}\n", row["trace_seconds"].get<double>(), row["different"].get<std::uint64_t>());
}

std::string volumes_line(const json &row) {
    const json &all = row["rays"]["all"];
    if (!all.contains("idle_volumes")) return "";
    return fmt::format("{} {}: of volumes per ray {:.2f} are missed, {:.2f} entered in vain, {:.2f} entered and an object met\n",
                       row["scene"].get<std::string>(), row["accelerator"].get<std::string>(), all["missed_volumes"].get<double>(),
                       all["idle_volumes"].get<double>(), all["served_volumes"].get<double>());
}

}  // namespace

json accelerator_json(const AcceleratorRow &row) {
    const double count = std::max<double>(1, double(row.primitives + row.instances));
    json all = {{"scene", row.scene},
                {"accelerator", row.accelerator},
                {"packets", row.packets},
                {"primitives", row.primitives},
                {"instances", row.instances},
                {"node_bytes", row.node_bytes},
                {"block_bytes", row.block_bytes},
                {"node_bytes_per_primitive", double(row.node_bytes) / count},
                {"block_bytes_per_primitive", double(row.block_bytes) / count},
                {"build_seconds", row.build_seconds},
                {"trace_seconds", trace_seconds(row)},
                {"different", row.different()},
                {"rays", {{"all", all_json(row)}}}};
    for (std::size_t use = 0; use < ray_uses; ++use) all["rays"][names_of_uses[use]] = use_json(row.uses[use]);
    return all;
}

std::string accelerators_text(const json &rows) {
    std::size_t of_scene = 6;
    for (const json &row : rows) of_scene = std::max(of_scene, row["scene"].get<std::string>().size() + 1);
    const int width = static_cast<int>(of_scene);
    std::string text = fmt::format("{:<{}}{:<16}{:>8}{:>9}{:>16} {:>25} {:>25} {:>25}\n", "", width, "", "", "", "B/primitive", "camera rays",
                                   "secondary rays", "shadow rays");
    text += fmt::format("{:<{}}{:<16}{:>8}{:>9}{:>8}{:>8}", "scene", width, "accelerator", "packets", "build s", "nodes", "blocks");
    for (int use = 0; use < 3; ++use) text += fmt::format(" {:>9}{:>8}{:>8}", "tests", "steps", "M/s");
    text += fmt::format("{:>10}{:>10}\n", "trace s", "different");
    for (const json &row : rows) text += line(row, width);
    for (const json &row : rows) text += volumes_line(row);
    return text;
}

}  // namespace brandung
