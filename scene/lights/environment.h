/// The picture all around as a light of integrator path.
#pragma once
#include <vector>

#include "kernels/lights/environment.h"
#include "scene/textures/texture.h"

namespace brandung {

/// By what directions are chosen.
struct EnvironmentTable {
    std::vector<EnvironmentRow> rows;    ///< from the top
    std::vector<EnvironmentCell> cells;  ///< row by row, from the picture's left edge
    float radiance = 0;                  ///< mean of all directions and channels
    uint columns() const { return rows.empty() ? 0 : static_cast<uint>(cells.size() / rows.size()); }
};

/// Of a latitude-longitude picture of which every texel counts `scale` times. Each cell is as likely as its solid angle times the mean of what
/// kernels find in it between texels, so that none is left out from which light comes, but for what 2^-24 of a row, or rows, cannot tell from none.
/// Empty if all is black.
EnvironmentTable make_environment(const Picture &picture, Spectrum scale);

}  // namespace brandung
