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

}  // namespace

Light make_light(const EmissiveMesh &light) { return make_emissive("emissive_mesh", light); }
Light make_light(const EmissiveSphere &light) { return make_emissive("emissive_sphere", light); }
Light make_light(const EmissiveFrustum &light) { return make_emissive("emissive_frustum", light); }

void append_strata(const Light &light, uint rows, std::vector<Light> &lights) {
    for (uint row = 0; row < rows; ++row)
        for (uint column = 0; column < rows; ++column) {
            Light cell = light;
            Emission emission;
            std::memcpy(&emission, cell.words, sizeof emission);
            emission.power /= float(rows * rows);
            emission.stratum = {.salt = uint(lights.size()), .rows = rows, .column_and_row = column | row << 16};
            write_words(emission, cell.words);
            lights.push_back(cell);
        }
}

}  // namespace brandung
