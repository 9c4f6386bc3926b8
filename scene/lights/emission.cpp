/// Emissive shapes as lights.
#include <cstring>

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

Emission emission_of(const Light &light) {
    Emission emission;
    std::memcpy(&emission, light.words, sizeof emission);
    return emission;
}

}  // namespace

Light make_light(const EmissiveMesh &light) { return make_emissive("emissive_mesh", light); }
Light make_light(const EmissiveSphere &light) { return make_emissive("emissive_sphere", light); }
Light make_light(const EmissiveFrustum &light) { return make_emissive("emissive_frustum", light); }

std::vector<Light> make_cells(const Light &light, uint rows) {
    std::vector<Light> cells;
    for (uint row = 0; row < rows; ++row)
        for (uint column = 0; column < rows; ++column) {
            Emission emission = emission_of(light);
            emission.power /= float(rows * rows);
            emission.stratum = {.salt = 0, .rows = rows, .column_and_row = column | row << 16};
            write_words(emission, cells.emplace_back(light).words);
        }
    return cells;
}

void append_cells(const std::vector<Light> &cells, Spectrum radiance, uint instance, std::vector<Light> &lights) {
    for (const Light &cell : cells) {
        Emission emission = emission_of(cell);
        emission.power *= radiance;
        emission.stratum.salt = uint(lights.size());
        emission.instance = instance;
        write_words(emission, lights.emplace_back(cell).words);
    }
}

}  // namespace brandung
