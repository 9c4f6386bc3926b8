// Stands for cameras/shutter.cl where nothing moves: samples have no time.
#pragma once
#include "kernels/core/items.h"
#include "kernels/core/params.h"

typedef float CameraMotion;  ///< there is none

FUNCTION float time_of_sample(uint pixel, uint sample, BatchParams batch, ShutterParams shutter) { return 0.0f; }
FUNCTION Ray moved_with_camera(Ray ray, const global CameraMotion *motion, ShutterParams shutter, float time) { return ray; }
FUNCTION void store_time(global uint *sources, uint i, float time) {}
