// A circle full of directions.
#pragma once
#include "kernels/cameras/camera_ray.cl"
#include "kernels/cameras/fisheye.h"
#include "kernels/core/math.cl"

typedef Fisheye CameraView;

FUNCTION CameraView camera_view(Camera camera) {
    CameraView view;
    view.forward = CAMERA_VECTOR(camera, 0), view.right = CAMERA_VECTOR(camera, 3), view.up = CAMERA_VECTOR(camera, 6);
    view.aspect = camera.words[9], view.angle = camera.words[10], view.sine = camera.words[11], view.equisolid = camera.words[12];
    return view;
}

/// Picture point (x, y) from the circle's middle, to the right and upwards, in units of its radius.
FUNCTION vec2 place_in_circle(CameraView view, float x, float y) {
    vec2 place;
    place.x = (2.0f * x - 1.0f) * view.aspect, place.y = 1.0f - 2.0f * y;
    return place;
}

FUNCTION float distance_from_middle(vec2 place) { return sqrt(fma(place.x, place.x, place.y * place.y)); }

/// Whether there is a ray through picture point (x, y).
FUNCTION void store_seen(global uchar *seen, uint i, CameraView view, float x, float y) {
    seen[i] = distance_from_middle(place_in_circle(view, x, y)) <= 1.0f;
}

/// Cosine (x) and sine (y) of the angle to the axis.
FUNCTION vec2 angle_at(CameraView view, float distance) {
    const vec2 equidistant = turn(minimum(distance, 1.0f) * view.angle);
    const float half_sine = minimum(distance, 1.0f) * view.sine, half_cosine = sqrt(maximum(fma(-half_sine, half_sine, 1.0f), 0.0f));
    vec2 angle;
    angle.x = view.equisolid > 0.0f ? fma(-2.0f * half_sine, half_sine, 1.0f) : equidistant.x;
    angle.y = view.equisolid > 0.0f ? 2.0f * half_sine * half_cosine : equidistant.y;
    return angle;
}

/// The ray through picture point (x, y), which is in the circle.
FUNCTION Ray camera_ray(vec3 position, CameraView view, float x, float y, vec2 random) {
    const vec2 place = place_in_circle(view, x, y);
    const float distance = distance_from_middle(place);
    const vec2 angle = angle_at(view, distance);
    const float aside = distance > 0.0f ? angle.y / distance : 0.0f;
    const vec3 way = plus(scaled(view.right, aside * place.x), scaled(view.up, aside * place.y));
    return ray_from_eye(position, unit(plus(scaled(view.forward, angle.x), way)));
}
