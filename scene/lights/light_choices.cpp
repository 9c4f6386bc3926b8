#include "scene/lights/light_choices.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include "scene/kinds.h"
#include "scene/lights/aliases.h"
#include "scene/lights/light.h"

namespace brandung {
namespace {

double mean_of(Spectrum s) { return (double(s.x) + s.y + s.z) / 3; }

/// A normal of what shines and is flat, of any length.
std::optional<glm::dvec3> normal_of(const Light &light) {
    if (light.kind == kind_number(light_kinds(), "emissive_disk")) return glm::dvec3(view_of<EmissiveDisk>(light.words).normal);
    if (light.kind != kind_number(light_kinds(), "emissive_flat")) return {};
    const auto face = view_of<EmissiveFlat>(light.words);
    return glm::cross(glm::dvec3(face.u), glm::dvec3(face.v));
}

/// The area of an emissive shape in the world, over that in its group's space: see emissive_area_in_power in lights/emissive_instances.cl.
double stretch_of(const Light &light, const Transform &to_world) {
    const glm::dmat3 m(to_world.x, to_world.y, to_world.z);
    const glm::dvec3 x = glm::cross(m[1], m[2]), y = glm::cross(m[2], m[0]), z = glm::cross(m[0], m[1]);
    if (const auto normal = normal_of(light)) return glm::length(glm::dmat3(x, y, z) * *normal) / glm::length(*normal);
    return std::sqrt((glm::dot(x, x) + glm::dot(y, y) + glm::dot(z, z)) / 3);
}

/// Those of lights that are infinitely far are reduced to as much as the others have together, if these have any.
std::vector<double> powers_of(const LightRows &lights, const Scene &scene, float extent) {
    std::vector<double> powers;
    double sums[2] = {0, 0};
    for (std::size_t row = 0; row < lights.rows.size(); ++row) {
        const Light &light = lights.rows[row];
        const LightKind &kind = light_kinds()[light.kind];
        const uint instance = lights.shapes[row].instance;
        const double stretch = instance != 0 ? stretch_of(light, scene.instances[instance - 1].transforms.to_world) : 1;
        sums[kind.is_far] += powers.emplace_back(mean_of(kind.power(light, extent)) * stretch);
    }
    const double reduction = sums[0] > 0 && sums[1] > sums[0] ? sums[0] / sums[1] : 1;
    for (std::size_t row = 0; row < powers.size(); ++row) powers[row] *= light_kinds()[lights.rows[row].kind].is_far ? reduction : 1;
    return powers;
}

}  // namespace

LightChoices make_light_choices(const LightRows &lights, const Scene &scene, float extent) {
    const std::vector<double> powers = powers_of(lights, scene, extent);
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
