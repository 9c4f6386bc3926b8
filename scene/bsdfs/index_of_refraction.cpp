#include "scene/bsdfs/index_of_refraction.h"

#include <fmt/format.h>

#include "scene/parameters.h"

namespace brandung {

std::string why_no_index(float index) {
    return fmt::format("must be from {:g} to {:g}, got {:g} (ratios of indices are squared, which must fit into a float)", min_index, max_index,
                       index);
}

float read_index(const Parameters &parameters) {
    const float index = parameters.positive("eta", 1.5f);
    if (!is_permitted_index(index)) parameters.fail("eta", why_no_index(index));
    return index;
}

}  // namespace brandung
