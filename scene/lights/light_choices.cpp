#include "scene/lights/light_choices.h"

#include <limits>
#include <numbers>
#include <numeric>

#include "scene/lights/aliases.h"
#include "scene/lights/light.h"

namespace brandung {
namespace {

double mean_of(Spectrum s) { return (double(s.x) + s.y + s.z) / 3; }

}  // namespace

LightChoices make_light_choices(const LightRows &lights, const Scene &scene, float extent) {
    std::vector<double> powers;
    for (const Light &light : lights.rows) powers.push_back(mean_of(light_kinds()[light.kind].power(light, extent)));
    const double sum = std::accumulate(powers.begin(), powers.end(), 0.0);
    if (!(sum > 0)) return {};
    const std::vector<Alias> aliases = make_aliases(powers);
    LightChoices result;
    for (std::size_t row = 0; row < powers.size(); ++row) {
        const PlacedShape &placed = lights.shapes[row];
        const double radiance = placed.shape ? mean_of(scene.materials[placed.material].record.emission) : std::numeric_limits<double>::infinity();
        result.choices.push_back({aliases[row].kept, aliases[row].alias, float(sum / powers[row]), float(radiance)});
    }
    result.emission = float(2 * std::numbers::pi / sum);
    return result;
}

}  // namespace brandung
