/// The picture all around as a light of integrator path.
#pragma once
#include <vector>

#include "kernels/lights/environment.h"
#include "scene/textures/texture.h"

namespace brandung {

/// By what directions are chosen.
struct EnvironmentTable {
    std::vector<EnvironmentRow> rows;  ///< from the top, and one more
    std::vector<float> begins;  ///< of each row: where in [0, 1] its cells begin, from the picture's left edge on, and 1, every ENVIRONMENT_STRIDE
    std::vector<float> marks;   ///< of each row: every ENVIRONMENT_MARKth of these
    uint columns = 0;           ///< cells of a row
    float radiance = 0;         ///< mean of all directions and channels
    uint row_count() const { return rows.empty() ? 0 : static_cast<uint>(rows.size()) - 1; }
};

/// Of a latitude-longitude picture of which every texel counts `scale` times. Each cell is as likely as its solid angle times the mean of what
/// kernels find in it between texels, so that none is left out from which light comes, but for what 2^-24 of a row, or rows, cannot tell from none.
/// Empty if all is black.
EnvironmentTable make_environment(const Picture &picture, Spectrum scale);

}  // namespace brandung
