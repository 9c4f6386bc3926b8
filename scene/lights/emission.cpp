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

/// The light, of radiance 1, with this material's emission in an instance.
template <class View> View shining(const Light &light, const Material &material, uint instance) {
    View view = view_of<View>(light.words);
    view.power *= material.emission;
    view.instance = instance;
    view.dark = material.flags & (MATERIAL_DARK_FRONT | MATERIAL_DARK_BACK);
    return view;
}

/// Of radiance 1, per area. What shines to one side only counts as if it did to both: rays that meet it tell its density by its radiance alone.
constexpr float both_sides = 2 * std::numbers::pi_v<float>;

}  // namespace

Light make_light(const EmissiveMesh &light) { return make_emissive("emissive_mesh", light); }
Light make_light(const EmissiveSphere &light) { return make_emissive("emissive_sphere", light); }
Light make_light(const EmissiveFrustum &light) { return make_emissive("emissive_frustum", light); }
Light make_light(const EmissiveDisk &light) { return make_emissive("emissive_disk", light); }

Light make_light(const EmissiveFlat &light) { return make_emissive("emissive_flat", light); }

Spectrum power_of_emissive_flat(const Light &light, float) { return view_of<EmissiveFlat>(light.words).power * both_sides; }
Spectrum power_of_emissive_mesh(const Light &light, float) { return view_of<Emission>(light.words).power * both_sides; }
Spectrum power_of_emissive_frustum(const Light &light, float) { return view_of<Emission>(light.words).power * both_sides; }
Spectrum power_of_emissive_disk(const Light &light, float) { return view_of<Emission>(light.words).power * both_sides; }

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
    const uint flat = kind_number(light_kinds(), "emissive_flat");
    for (const Light &cell : cells) {
        Light &light = lights.emplace_back(cell);
        if (cell.kind == flat) {
            write_words(shining<EmissiveFlat>(cell, material, instance), light.words);
            continue;
        }
        auto emission = shining<Emission>(cell, material, instance);
        emission.stratum.salt = uint(lights.size() - 1);
        write_words(emission, light.words);
    }
}

}  // namespace brandung
