#include "tools/bench/traversal_report.h"

#include <fmt/format.h>

#include "tools/median.h"

namespace brandung {
namespace {

using nlohmann::json;

json mrays(std::size_t count, const std::vector<double> &seconds) {
    return seconds.empty() ? json() : json(1e-6 * static_cast<double>(count) / median(seconds));
}

/// The fastest of Embree's functions for these rays, on robust scenes or default ones.
json best_peer(const TraversalResult &result, const std::string &rays, bool robust) {
    json best;
    for (const PeerRow &peer : result.peers) {
        if (peer.rays != rays || peer.robust != robust || peer.seconds.empty()) continue;
        const json speed = mrays(peer.count, peer.seconds);
        if (best.is_null() || speed > best["mrays_per_s"]) best = {{"mrays_per_s", speed}, {"api", peer.scene + " " + peer.api}};
    }
    return best;
}

json ratio(const json &speed, const json &best) {
    return speed.is_null() || best.is_null() ? json() : json(speed.get<double>() / best["mrays_per_s"].get<double>());
}

json row_json(const TraversalResult &result, const TraversalRow &row, const std::string &variant) {
    const json speed = mrays(row.count, row.seconds), best = best_peer(result, row.rays, false), robust = best_peer(result, row.rays, true);
    return {{"scene", result.scene},
            {"triangles", result.primitives},
            {"rays", row.rays},
            {"count", row.count},
            {"variant", variant},
            {"kernel", row.kernel},
            {"kernel_hash", fmt::format("{:016x}", row.kernel_hash)},
            {"mrays_per_s", speed},
            {"mrays_per_device_s", mrays(row.count, row.device_seconds)},
            {"embree_best", best.is_null() ? json() : best["mrays_per_s"]},
            {"embree_best_api", best.is_null() ? json() : best["api"]},
            {"embree_best_robust", robust.is_null() ? json() : robust["mrays_per_s"]},
            {"embree_best_robust_api", robust.is_null() ? json() : robust["api"]},
            {"ratio", ratio(speed, best)},
            {"ratio_robust", ratio(speed, robust)},
            {"different", row.different},
            {"mismatches", result.peers.empty() ? json() : json(row.mismatches)}};
}

std::string cell(const json &value, int width, int digits) {
    return value.is_null() ? fmt::format("{:>{}}", "-", width) : fmt::format("{:>{}.{}f}", value.get<double>(), width, digits);
}

std::string text_or_dash(const json &value) { return value.is_null() ? "-" : value.get<std::string>(); }

}  // namespace

void add_traversal_json(json &all, const TraversalResult &result) {
    json scene = {{"scene", result.scene},
                  {"accelerator", result.accelerator},
                  {"primitives", result.primitives},
                  {"instances", result.instances},
                  {"node_bytes", result.node_bytes},
                  {"block_bytes", result.block_bytes},
                  {"build_seconds", result.build_seconds},
                  {"embree", json::array()}};
    for (const PeerScene &peer : result.peer_scenes)
        scene["embree"].push_back({{"scene", peer.name}, {"build_seconds", peer.build_seconds}, {"bytes", peer.bytes}});
    all["scenes"].push_back(scene);
    for (const TraversalRow &row : result.rows) {
        all["rows"].push_back(row_json(result, row, row.variant));
        if (row.of_render) all["rows"].push_back(row_json(result, row, "render"));
    }
    for (const PeerRow &peer : result.peers)
        all["embree_rows"].push_back({{"scene", result.scene},
                                      {"rays", peer.rays},
                                      {"embree_scene", peer.scene},
                                      {"api", peer.api},
                                      {"mrays_per_s", mrays(peer.count, peer.seconds)}});
    if (!result.peer_version.empty()) all["embree"] = {{"version", result.peer_version}, {"native_width", result.peer_width}};
}

std::string traversal_text(const json &all) {
    std::size_t width = 6;
    for (const json &row : all["rows"]) width = std::max(width, row["scene"].get<std::string>().size() + 1);
    const int wide = static_cast<int>(width);
    std::string text = fmt::format("{:<{}}{:<10}{:<13}{:>9}{:>9}{:>7}  {:<22}{:>9}{:>7}  {:<22}{:>10}{:>11}  {}\n", "scene", wide, "rays", "variant",
                                   "Mrays/s", "Embree", "ratio", "which", "robust", "ratio", "which", "different", "mismatches", "kernel");
    for (const json &row : all["rows"])
        text += fmt::format("{:<{}}{:<10}{:<13}{}{}{}  {:<22}{}{}  {:<22}{:>10}{:>11}  {}\n", row["scene"].get<std::string>(), wide,
                            row["rays"].get<std::string>(), row["variant"].get<std::string>(), cell(row["mrays_per_s"], 9, 2),
                            cell(row["embree_best"], 9, 2), cell(row["ratio"], 7, 2), text_or_dash(row["embree_best_api"]),
                            cell(row["embree_best_robust"], 9, 2), cell(row["ratio_robust"], 7, 2), text_or_dash(row["embree_best_robust_api"]),
                            row["different"].get<std::uint64_t>(), row["mismatches"].is_null() ? "-" : row["mismatches"].dump(),
                            row["kernel_hash"].get<std::string>());
    return text;
}

}  // namespace brandung
