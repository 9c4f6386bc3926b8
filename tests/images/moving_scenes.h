/// Scenes that move while the shutter is open, and what their pictures are compared with.
#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/scenes.h"
#include "tests/support/statistics/blocks.h"

namespace brandung::motion {

inline constexpr uint width = 32, height = 24;

/// Seen from the front, without perspective: a pixel is 1/4 wide.
Scene scene_of(const std::string &integrator);
/// What moves is seen because it shines; it gives no light.
Scene shining_scene();
/// Bars and balls in different instances that move in different ways, and one that does not.
Scene moving_scene(const std::string &integrator);

/// What the group consists of is added to the scene by `add`.
template <class Add> uint group_of(Scene &scene, const Add &add) {
    auto world = std::exchange(scene.shapes, {});
    add(scene);
    return add_group(scene, "group", std::exchange(scene.shapes, std::move(world)));
}
uint ball(Scene &scene, uint material, float radius);
uint bar(Scene &scene, uint material);
void move(Scene &scene, uint group, const AffineMap &from, const AffineMap &to);

inline double luminance(vec3 v) { return double(v.x + v.y + v.z) / 3; }

std::vector<statistics::Estimate> blocks_of(const Scene &scene);
/// Of what still scenes show at many times, each one of its own, anywhere in its part of those from 0 to 1.
std::vector<statistics::Estimate> mean_of_stills(const std::function<Scene(double time)> &at);

}  // namespace brandung::motion
