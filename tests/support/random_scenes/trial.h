/// What becomes of a random scene: whether accelerators, batches and kernels agree on it.
#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace brandung {

/// Reads random_scene(seed, scale) from a file in a folder with the pictures and meshes that it names. Throws SceneError if the scene is refused.
Scene read_random_scene(std::uint64_t seed, double scale = 1);

/// What is wrong with renderings of a scene, a line each: its film, its counts of rays and hits must be the same with every accelerator and for other
/// batches, with kernels for all kinds of things, and if asked for with those made for the scene; and every contribution is finite. So must be those
/// of the same scene at another scale, a power of two, if that is given.
std::vector<std::string> faults_of(Scene &scene, bool specialised, Scene *scaled = nullptr);

/// Whether all that a scene has is in its file: no mesh has a scale of its own.
bool is_scalable(const Scene &scene);

}  // namespace brandung
