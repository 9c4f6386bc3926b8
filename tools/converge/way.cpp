#include "tools/converge/way.h"

namespace brandung {
namespace {

std::string value_of(const Way &way, const std::string &setting) {
    const auto found = way.settings.find(setting);
    return found == way.settings.end() ? "" : found->second;
}

bool either(const Way &a, const Way &b, const std::string &bias) { return a.biased_by.contains(bias) || b.biased_by.contains(bias); }

/// Whether two values of a setting, which are not the same, lead to other pictures.
bool counts(const std::string &setting, const Way &a, const Way &b) {
    if (setting == "max_depth") return either(a, b, "depth limit");
    if (setting == "follow") return either(a, b, "adaptive depth");  // which child a weight ends is another question then
    if (setting == "shadows") return a.transmits && b.transmits;
    if (setting == "light_samples") return value_of(a, setting) == "0" || value_of(b, setting) == "0";
    return true;
}

}  // namespace

std::vector<Departure> departures(const Way &way, const Way &other) {
    std::vector<Departure> all;
    for (const char *setting :
         {"scene_hash", "camera", "integrator", "max_depth", "threshold", "light_samples", "follow", "shadows", "filter", "filter_radius", "splat"}) {
        const std::string own = value_of(way, setting), others = value_of(other, setting);
        if (own != others && counts(setting, way, other)) all.push_back({setting, own, others});
    }
    return all;
}

std::optional<std::string> part_of(const Way &way) {
    if (!way.settings.contains("crop")) return std::nullopt;
    return value_of(way, "crop") + " of " + value_of(way, "width") + " x " + value_of(way, "height");
}

}  // namespace brandung
