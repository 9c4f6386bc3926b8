/// Why something did not happen, in words: a child that was not spawned, a light that was not asked.
#pragma once
#include <string>

#include "kernels/core/params.h"
#include "runtime/inspection/ray_tree.h"
#include "scene/scene.h"

namespace brandung {

/// Child j of a ray: 0 is reflected, 1 refracted.
inline constexpr std::size_t reflected_child = 0, refracted_child = 1;
/// Whether the hit's material sends such rays at all; one that transmits mirrors where it reflects totally.
bool can_spawn(const TracedRay &parent, std::size_t j, const Material &material);
/// Of child j of a ray that hit something; empty if it was spawned.
std::string why_not_spawned(const TracedRay &parent, std::size_t j, const Material &material, const IntegratorSettings &settings);
/// Empty if its shadow ray was traced.
std::string why_not_asked(const TracedLight &light);

}  // namespace brandung
