// Parallel rays.
#pragma once
#include "kernels/cameras/camera_ray.cl"
#include "kernels/cameras/orthographic.h"

typedef Orthographic CameraView;
#include "kernels/cameras/whole_picture.cl"

FUNCTION CameraView camera_view(Camera camera) {
    CameraView view;
    view.corner = CAMERA_VECTOR(camera, 0), view.right = CAMERA_VECTOR(camera, 3), view.down = CAMERA_VECTOR(camera, 6);
    view.direction = CAMERA_VECTOR(camera, 9);
    return view;
}

/// The ray through picture point (x, y).
FUNCTION Ray camera_ray(vec3 position, CameraView view, float x, float y, vec2 random) {
    return ray_from_eye(plus(position, plus(view.corner, plus(scaled(view.right, x), scaled(view.down, y)))), view.direction);
}
