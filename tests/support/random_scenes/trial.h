/// What becomes of a random scene: whether accelerators, batches and kernels agree on it.
#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace brandung {

/// Reads random_scene(seed) from a file in a folder with the pictures and meshes that it names. Throws SceneError if the scene is refused.
Scene read_random_scene(std::uint64_t seed);

/// What is wrong with renderings of a scene, a line each: its film, its counts of rays and hits must be the same with every accelerator and for other
/// batches, with kernels for all kinds of things, and if asked for with those made for the scene; and every contribution is finite.
std::vector<std::string> faults_of(Scene &scene, bool specialised);

}  // namespace brandung
