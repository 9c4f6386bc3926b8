// A lens without thickness.
#pragma once
#include "kernels/cameras/camera_ray.cl"
#include "kernels/cameras/thin_lens.h"
#include "kernels/core/warp.cl"

typedef ThinLens CameraView;
#include "kernels/cameras/whole_picture.cl"

FUNCTION CameraView camera_view(Camera camera) {
    CameraView view;
    view.corner = CAMERA_VECTOR(camera, 0), view.right = CAMERA_VECTOR(camera, 3), view.down = CAMERA_VECTOR(camera, 6);
    view.across = CAMERA_VECTOR(camera, 9), view.along = CAMERA_VECTOR(camera, 12);
    view.blades = camera.words[15], view.turned = camera.words[16];
    return view;
}

/// A corner of the aperture on the unit circle; 0 <= number <= blades.
FUNCTION vec2 aperture_corner(CameraView view, float number) {
    const float turns = number / view.blades + view.turned;
    return turn(turns < 1.0f ? turns : turns - 1.0f);
}

/// Uniform on the polygon: by equal triangles between its middle and two corners, as `random.x` says, and there by the root of what is left of that.
FUNCTION vec2 point_of_polygon(CameraView view, vec2 random) {
    const float triangles = random.x * view.blades, number = minimum((float)(int)triangles, view.blades - 1.0f);
    const vec2 first = aperture_corner(view, number), second = aperture_corner(view, number + 1.0f);
    const float outwards = sqrt(triangles - number);
    vec2 p;
    p.x = outwards * fma(random.y, second.x - first.x, first.x), p.y = outwards * fma(random.y, second.y - first.y, first.y);
    return p;
}

/// Uniform on the aperture, in units of the lens's radius.
FUNCTION vec2 lens_point(CameraView view, vec2 random) {
    const vec2 of_disk = concentric_disk(random), of_polygon = point_of_polygon(view, random);
    vec2 p;
    p.x = view.blades > 0.0f ? of_polygon.x : of_disk.x, p.y = view.blades > 0.0f ? of_polygon.y : of_disk.y;
    return p;
}

/// A ray through picture point (x, y), from where on the lens `random` says.
FUNCTION Ray camera_ray(vec3 position, CameraView view, float x, float y, vec2 random) {
    const vec2 lens = lens_point(view, random);
    const vec3 offset = plus(scaled(view.across, lens.x), scaled(view.along, lens.y));
    const vec3 sharp = plus(view.corner, plus(scaled(view.right, x), scaled(view.down, y)));
    return ray_from_eye(plus(position, offset), unit(minus(sharp, offset)));
}
