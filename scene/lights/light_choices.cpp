#include "scene/lights/light_choices.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <numeric>

#include "scene/lights/aliases.h"
#include "scene/lights/light.h"

namespace brandung {
namespace {

double mean_of(Spectrum s) { return (double(s.x) + s.y + s.z) / 3; }

/// Those of lights that are infinitely far are reduced to as much as the others have together, if these have any.
std::vector<double> powers_of(const LightRows &lights, float extent) {
    std::vector<double> powers;
    double sums[2] = {0, 0};
    for (const Light &light : lights.rows) {
        const LightKind &kind = light_kinds()[light.kind];
        sums[kind.is_far] += powers.emplace_back(mean_of(kind.power(light, extent)));
    }
    const double reduction = sums[0] > 0 && sums[1] > sums[0] ? sums[0] / sums[1] : 1;
    for (std::size_t row = 0; row < powers.size(); ++row) powers[row] *= light_kinds()[lights.rows[row].kind].is_far ? reduction : 1;
    return powers;
}

}  // namespace

LightChoices make_light_choices(const LightRows &lights, const Scene &scene, float extent) {
    const std::vector<double> powers = powers_of(lights, extent);
    const double sum = std::accumulate(powers.begin(), powers.end(), 0.0);
    if (!(sum > 0)) return {};
    const std::vector<Alias> aliases = make_aliases(powers);
    LightChoices result;
    for (std::size_t row = 0; row < powers.size(); ++row) {
        const PlacedShape &placed = lights.shapes[row];
        const double radiance = placed.shape ? mean_of(scene.materials[placed.material].record.emission) : std::numeric_limits<double>::infinity();
        result.choices.push_back({aliases[row].kept, aliases[row].alias, float(sum / powers[row]), float(radiance)});
    }
    const bool asks_shapes = std::any_of(lights.shapes.begin(), lights.shapes.end(), [](const PlacedShape &placed) { return placed.shape; });
    if (asks_shapes) result.emission = float(2 * std::numbers::pi / sum);
    if (!lights.environment.rows.empty()) result.environment = float(powers.back() / sum / (4 * std::numbers::pi));
    return result;
}

}  // namespace brandung
