/// Why something did not happen, in words: a child that was not spawned, a light that was not asked.
#pragma once
#include <string>

#include "kernels/core/params.h"
#include "runtime/inspection/ray_tree.h"
#include "scene/scene.h"

namespace brandung {

/// Whether the hit's material sends rays of this kind, RAY_REFLECTED or RAY_REFRACTED, at all; one that transmits mirrors where it reflects totally.
bool can_spawn(const TracedRay &parent, uint kind, const Material &material);
/// The ray of such a kind that it may spawn; null if none was considered, since the other was chosen.
const TracedChild *child_of_kind(const TracedRay &parent, uint kind);
/// Of such a child of a ray that hit something; empty if it was spawned.
std::string why_not_spawned(const TracedRay &parent, uint kind, const Material &material, const IntegratorSettings &settings);
/// The same of a part of a path's bundle, or of the only one.
std::string why_not_continued(const TracedRay &parent, const TracedChild &child, const IntegratorSettings &settings);
/// Empty if its shadow ray was traced.
std::string why_not_asked(const TracedLight &light);

}  // namespace brandung
