/// The parts of compile(): each lays out its records in the arena, and notes what is in use.
#pragma once
#include <algorithm>
#include <vector>

#include "scene/compilation/arena.h"
#include "scene/compile.h"

namespace brandung {

/// Primitives, their accelerators, and instances. Throws SceneError, before anything is built if they cannot fit.
void add_primitives(const Scene &scene, const CompileOptions &options, CompiledScene &compiled, Arena &arena);
/// And textures. Follows add_primitives().
void add_materials(const Scene &scene, const CompileOptions &options, CompiledScene &compiled, Arena &arena);
/// Follows add_materials().
void add_lights(const Scene &scene, CompiledScene &compiled, Arena &arena);

/// Each once, in ascending order.
template <class Records> std::vector<uint> kinds_of(const Records &records) {
    std::vector<uint> kinds;
    for (const auto &record : records) kinds.push_back(record.kind);
    std::sort(kinds.begin(), kinds.end());
    kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());
    return kinds;
}

}  // namespace brandung
