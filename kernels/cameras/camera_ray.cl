// How rays begin at the eye, whatever the camera.
#pragma once
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/params.h"
#include "kernels/core/spawn.cl"

/// `direction` has unit length.
FUNCTION Ray ray_from_eye(vec3 origin, vec3 direction) { return ray_spawn(origin, direction, RAY_CAMERA, NO_HIT); }

/// Three of a camera's words.
#define CAMERA_VECTOR(camera, first) make3(camera.words[first], camera.words[first + 1], camera.words[first + 2])
