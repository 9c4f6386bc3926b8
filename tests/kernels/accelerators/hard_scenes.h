/// Scenes and rays that accelerators find hard.
#pragma once
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "kernels/core/items.h"
#include "scene/scene.h"

namespace brandung {

struct SceneKind {
    std::string name;
    std::function<Scene()> make;
    vec3 centre;  ///< rays go about it
};
void PrintTo(const SceneKind &kind, std::ostream *out);
/// Some by hand, and one of each kind of primitive.
std::vector<SceneKind> scene_kinds();

/// Three times the same, in an order that separates equals; triangles also as smooth ones. Groups have one of each kind, and first these two.
Scene duplicates();

/// Rays of every sort that has made an accelerator lose hits somewhere.
std::vector<Ray> make_rays(const Scene &scene, vec3 centre);

}  // namespace brandung
