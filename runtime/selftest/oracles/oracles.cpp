/// The list of oracles, by kind.
#include "runtime/selftest/oracles/oracles.h"

#include <algorithm>
#include <stdexcept>

namespace brandung {
namespace {

const std::vector<std::unique_ptr<PrimitiveOracle>> &known_oracles() {
    static const auto oracles = [] {
        std::vector<std::unique_ptr<PrimitiveOracle>> list;
        for (const auto make : {make_sphere_oracle, make_triangle_oracle, make_smooth_triangle_oracle, make_frustum_oracle, make_disk_oracle})
            list.push_back(make());
        return list;
    }();
    return oracles;
}

const PrimitiveOracle &oracle_of(const PrimitiveKind &kind) {
    const auto &all = known_oracles();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto &oracle) { return &oracle->kind() == &kind; });
    if (found == all.end()) throw std::out_of_range("runtime/selftest/oracles has no oracle of '" + std::string(kind.name) + "'");
    return **found;
}

}  // namespace

const std::vector<const PrimitiveOracle *> &primitive_oracles() {
    static const auto oracles = [] {
        std::vector<const PrimitiveOracle *> list;
        for (const PrimitiveKind *kind : primitive_kinds()) list.push_back(&oracle_of(*kind));
        return list;
    }();
    return oracles;
}

}  // namespace brandung
