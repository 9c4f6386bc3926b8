/// Emissive shapes as lights.
#include <numbers>

#include "scene/kinds.h"
#include "scene/lights/light.h"

namespace brandung {
namespace {

template <class View> Light make_emissive(const char *kind, const View &view) {
    Light result{};
    result.kind = kind_number(light_kinds(), kind);
    write_words(view, result.words);
    return result;
}

/// Of radiance 1, per area. What shines to one side only counts as if it did to both: rays that meet it tell its density by its radiance alone.
constexpr float both_sides = 2 * std::numbers::pi_v<float>;

}  // namespace

Light make_light(const EmissiveMesh &light) { return make_emissive("emissive_mesh", light); }
Light make_light(const EmissiveSphere &light) { return make_emissive("emissive_sphere", light); }
Light make_light(const EmissiveFrustum &light) { return make_emissive("emissive_frustum", light); }

Spectrum power_of_emissive_mesh(const Light &light, float) { return view_of<Emission>(light.words).power * both_sides; }
Spectrum power_of_emissive_frustum(const Light &light, float) { return view_of<Emission>(light.words).power * both_sides; }

/// The record's `power` has no area in it.
Spectrum power_of_emissive_sphere(const Light &light, float) {
    const auto sphere = view_of<EmissiveSphere>(light.words);
    return sphere.emission.power * (both_sides * 4 * std::numbers::pi_v<float> * sphere.radius * sphere.radius);
}

std::vector<Light> make_cells(const Light &light, uint rows) {
    std::vector<Light> cells;
    for (uint row = 0; row < rows; ++row)
        for (uint column = 0; column < rows; ++column) {
            auto emission = view_of<Emission>(light.words);
            emission.power /= float(rows * rows);
            emission.stratum = {.salt = 0, .cell = column | row << 8 | rows << 16};
            write_words(emission, cells.emplace_back(light).words);
        }
    return cells;
}

void append_cells(const std::vector<Light> &cells, const Material &material, uint instance, std::vector<Light> &lights) {
    for (const Light &cell : cells) {
        auto emission = view_of<Emission>(cell.words);
        emission.power *= material.emission;
        emission.stratum.salt = uint(lights.size());
        emission.instance = instance;
        emission.dark = material.flags & (MATERIAL_DARK_FRONT | MATERIAL_DARK_BACK);
        write_words(emission, lights.emplace_back(cell).words);
    }
}

}  // namespace brandung
