/// Rays that every traversal traces alike: those of a camera, and those that leave what they hit.
#pragma once
#include <functional>
#include <string>

#include "runtime/accelerators/ray_tracing.h"
#include "tools/bench/scene_geometry.h"

namespace brandung {

/// Rays that are traced together. Their tags say which primitive they leave, as those of a render do, and they begin beyond the rounding of where
/// they do: what a tracer finds at t >= 0 that does not know what they leave is right too.
struct RaySet {
    std::string name;
    RayQueue queue;
};

/// camera: through the middle of every pixel, in a render's order. diffuse: from what these hit, towards anywhere above the surface, by the cosine;
/// diffuse2: from what diffuse ones hit. shadow: from what camera rays hit to one point. any: the diffuse ones, asking whether anything is hit at
/// all.
const std::vector<std::string> &ray_set_names();

/// Where shadow rays end: the place of the first point or spot light (both kinds' words begin with it); without one, a point above the middle of all,
/// as far as that is wide.
vec3 shadow_light(const Scene &scene);

/// What the rays of a queue hit first.
using FindHits = std::function<RayAnswers(const RayQueue &)>;

/// The sets of these names, in the order of ray_set_names(). `light`: where shadow rays end.
std::vector<RaySet> make_ray_sets(const std::vector<std::string> &names, const Camera &camera, vec3 light, const SceneGeometry &geometry,
                                  const FindHits &find_hits);

}  // namespace brandung
