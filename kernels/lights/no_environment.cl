// Stands for lights/environment_density.cl in scenes whose background is no light.
#pragma once
#include "kernels/core/scene.cl"

FUNCTION float environment_density(Scene scene, vec3 direction) { return 0.0f; }
