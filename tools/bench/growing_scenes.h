/// Scenes of any number of objects, and rays through them: how accelerators grow.
#pragma once
#include <array>

#include "runtime/accelerators/ray_sample.h"
#include "scene/scene.h"

namespace brandung {

/// In the cube [0, 1]³, the same each time.
/// spheres: of one radius, anywhere, together 2 % of the cube's volume.
/// triangles: one mesh of them, whose three edges are N^(-1/3) / 2 long, anywhere and turned any way.
/// clumped: half of the spheres in a cluster in the middle, a hundredth as wide as the cube and as full as it would be of all.
inline constexpr std::array<const char *, 3> growing_scene_kinds = {"spheres", "triangles", "clumped"};
Scene growing_scene(const std::string &kind, uint objects);

/// So many rays from anywhere in the cube in any direction, which ask for the closest hit, and as many shadow rays between any two points in it.
std::vector<RayQueue> rays_in_cube(std::size_t count);

}  // namespace brandung
