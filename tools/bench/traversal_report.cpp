#include "tools/bench/traversal_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "tools/median.h"

namespace brandung {
namespace {

using nlohmann::json;

/// An own column for each of Embree's scenes, and the ends of the names of its members.
struct PeerColumn {
    const char *scene, *end;
};
constexpr std::array<PeerColumn, 3> peer_columns = {{{"medium", ""}, {"high", "_high"}, {"robust", "_robust"}}};

json mrays(std::size_t count, const std::vector<double> &seconds) {
    return seconds.empty() || count == 0 ? json() : json(1e-6 * static_cast<double>(count) / median(seconds));
}

/// The fastest of Embree's functions for these rays in one of its scenes; null where none was measured.
const PeerRow *fastest(const TraversalResult &result, const std::string &rays, const std::string &scene) {
    const PeerRow *best = nullptr;
    for (const PeerRow &row : result.peers) {
        if (row.rays != rays || result.peer_scenes[row.scene].name != scene || row.seconds.empty()) continue;
        if (!best || median(row.seconds) < median(best->seconds)) best = &row;
    }
    return best;
}

void add_peer_columns(json &all, const TraversalResult &result, const TraversalRow &row) {
    for (const PeerColumn &column : peer_columns) {
        const PeerRow *best = fastest(result, row.rays, column.scene);
        const json speed = best ? mrays(best->count, best->seconds) : json();
        const bool compared = !speed.is_null() && !all["mrays_per_s"].is_null();
        const std::string end = column.end;
        all["embree_best" + end] = speed;
        all["embree_best_api" + end] = best ? json(best->api.name()) : json();
        all["ratio" + end] = compared ? json(all["mrays_per_s"].get<double>() / speed.get<double>()) : json();
    }
}

void add_disagreement(json &all, const std::optional<Disagreement> &found) {
    const auto count = [&](std::uint64_t Disagreement::*member) { return found ? json(*found.*member) : json(); };
    all.update({{"mismatches", count(&Disagreement::mismatches)},
                {"judged", count(&Disagreement::judged)},
                {"ours_wrong", count(&Disagreement::ours_wrong)},
                {"theirs_wrong", count(&Disagreement::theirs_wrong)},
                {"ambiguous", count(&Disagreement::ambiguous)}});
}

json row_json(const TraversalResult &result, const TraversalRow &row, const std::string &variant) {
    json all = {{"scene", result.scene},
                {"triangles", result.primitives},
                {"rays", row.rays},
                {"count", row.count},
                {"variant", variant},
                {"kernel", row.kernel},
                {"kernel_hash", fmt::format("{:016x}", row.hash)},
                {"mrays_per_s", mrays(row.count, row.wall_seconds)},
                {"mrays_per_device_s", mrays(row.count, row.device_seconds)},
                {"different", row.different}};
    add_peer_columns(all, result, row);
    add_disagreement(all, row.disagreement);
    return all;
}

json peer_json(const TraversalResult &result, const PeerRow &row) {
    return {{"scene", result.scene},
            {"rays", row.rays},
            {"embree_scene", result.peer_scenes[row.scene].name},
            {"width", row.api.width},
            {"coherent", row.api.coherent},
            {"rounds", row.seconds.size()},
            {"mrays_per_s", mrays(row.count, row.seconds)}};
}

json scene_json(const TraversalResult &result) {
    const auto per_triangle = [&](std::size_t bytes) {
        return static_cast<double>(bytes) / static_cast<double>(std::max<std::size_t>(1, result.primitives));
    };
    json all = {{"scene", result.scene},
                {"accelerator", result.accelerator},
                {"triangles", result.primitives},
                {"instances", result.instances},
                {"builds", result.build_seconds.size()},
                {"build_seconds", median(result.build_seconds)},
                {"node_bytes", result.node_bytes},
                {"block_bytes", result.block_bytes},
                {"bytes_per_triangle", per_triangle(result.node_bytes + result.block_bytes)},
                {"embree", json::array()}};
    for (const PeerScene &peer : result.peer_scenes)
        all["embree"].push_back({{"embree_scene", peer.name},
                                 {"build_seconds", median(peer.build_seconds)},
                                 {"bytes", peer.bytes},
                                 {"bytes_per_triangle", per_triangle(peer.bytes)}});
    return all;
}

std::string cell(const json &value, int width, int digits) {
    return value.is_null() ? fmt::format("{:>{}}", "-", width) : fmt::format("{:>{}.{}f}", value.get<double>(), width, digits);
}

std::string count_cell(const json &value, int width) { return fmt::format("{:>{}}", value.is_null() ? "-" : value.dump(), width); }

/// "16 coherent" as "16c".
std::string api_cell(const json &value) {
    const std::string text = value.is_null() ? " -" : value.get<std::string>();
    const std::size_t space = text.find(' ');
    return fmt::format(" {:<3}", text.substr(0, space) + text[space + 1]);
}

std::string line(const json &row, int of_scene) {
    std::string text = fmt::format("{:<{}}{:<9}{:<12}{}", row["scene"].get<std::string>(), of_scene, row["rays"].get<std::string>(),
                                   row["variant"].get<std::string>(), cell(row["mrays_per_s"], 8, 2));
    for (const PeerColumn &column : peer_columns) {
        const std::string end = column.end;
        text += "  " + cell(row["embree_best" + end], 7, 2) + api_cell(row["embree_best_api" + end]) + cell(row["ratio" + end], 6, 2);
    }
    for (const char *count : {"mismatches", "judged", "ours_wrong", "theirs_wrong", "ambiguous", "different"}) text += count_cell(row[count], 10);
    return text + "  " + row["kernel_hash"].get<std::string>().substr(0, 8) + "\n";
}

std::string head(int of_scene) {
    std::string text = fmt::format("{:<{}}{:8}", "", of_scene + 9 + 12, "");
    for (const PeerColumn &column : peer_columns) text += fmt::format("  {:^17}", std::string("Embree ") + column.scene);
    text +=
        fmt::format("{:>10}{:>10}{:>10}{:>10}\n{:<{}}{:<9}{:<12}{:>8}", "mis-", "", "ours", "theirs", "scene", of_scene, "rays", "variant", "M/s");
    for (std::size_t i = 0; i < peer_columns.size(); ++i) text += fmt::format("  {:>7} {:<3}{:>6}", "M/s", "", "ratio");
    return text +
           fmt::format("{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}  {}\n", "matches", "judged", "wrong", "wrong", "ambiguous", "different", "kernel");
}

std::string scene_line(const json &scene) {
    std::string text =
        fmt::format("{}: {} triangles and other primitives, {} instances; {} built in {:.3f} s, {:.1f} B/primitive",
                    scene["scene"].get<std::string>(), scene["triangles"].get<std::size_t>(), scene["instances"].get<std::size_t>(),
                    scene["accelerator"].get<std::string>(), scene["build_seconds"].get<double>(), scene["bytes_per_triangle"].get<double>());
    for (const json &peer : scene["embree"])
        text += fmt::format("; Embree {} {:.3f} s, {:.1f}", peer["embree_scene"].get<std::string>(), peer["build_seconds"].get<double>(),
                            peer["bytes_per_triangle"].get<double>());
    return text + "\n";
}

}  // namespace

void add_traversal_json(json &all, const TraversalResult &result) {
    all["scenes"].push_back(scene_json(result));
    for (const TraversalRow &row : result.rows) {
        all["rows"].push_back(row_json(result, row, row.traversal->name));
        if (row.of_render) all["rows"].push_back(row_json(result, row, "render"));
    }
    for (const PeerRow &row : result.peers) all["embree_rows"].push_back(peer_json(result, row));
    if (!result.peer_version.empty())
        all["embree"] = {{"version", result.peer_version}, {"native_width", result.peer_width}, {"instructions", result.peer_instructions}};
}

std::string traversal_text(const json &all) {
    std::size_t width = 6;
    for (const json &row : all["rows"]) width = std::max(width, row["scene"].get<std::string>().size() + 1);
    std::string text = head(static_cast<int>(width));
    for (const json &row : all["rows"]) text += line(row, static_cast<int>(width));
    for (const json &scene : all["scenes"]) text += scene_line(scene);
    if (all.contains("embree"))
        text += fmt::format("Embree {} by {}, as far as its widest packets of {} rays and this processor tell; {} threads each\n",
                            all["embree"]["version"].get<std::string>(), all["embree"]["instructions"].get<std::string>(),
                            all["embree"]["native_width"].get<uint>(), all["compute_units"].get<uint>());
    return text;
}

}  // namespace brandung
