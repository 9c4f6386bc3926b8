// All around.
#pragma once
#include "kernels/cameras/camera_ray.cl"
#include "kernels/cameras/panorama.h"
#include "kernels/core/math.cl"

typedef Panorama CameraView;
#include "kernels/cameras/whole_picture.cl"

FUNCTION CameraView camera_view(Camera camera) {
    CameraView view;
    view.forward = CAMERA_VECTOR(camera, 0), view.right = CAMERA_VECTOR(camera, 3), view.up = CAMERA_VECTOR(camera, 6);
    view.width = camera.words[9], view.height = camera.words[10];
    return view;
}

/// Cosine (x) and sine (y) of an angle of either sign [turns, from -1 to 1].
FUNCTION vec2 signed_turn(float turns) {
    vec2 result = turn(fabs(turns));
    result.y = turns < 0.0f ? -result.y : result.y;
    return result;
}

/// The ray through picture point (x, y).
FUNCTION Ray camera_ray(vec3 position, CameraView view, float x, float y, vec2 random) {
    const vec2 longitude = signed_turn((x - 0.5f) * view.width), latitude = signed_turn((0.5f - y) * view.height);
    const vec3 level = plus(scaled(view.forward, longitude.x), scaled(view.right, longitude.y));
    return ray_from_eye(position, unit(plus(scaled(level, latitude.x), scaled(view.up, latitude.y))));
}
