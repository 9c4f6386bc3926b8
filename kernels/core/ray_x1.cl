// A ray prepared for tracing in a tenth of the room of a ray_x8: for those who keep several, or have one lane.
#pragma once
#include "kernels/core/rays.cl"

#include "kernels/core/lanes_1.cl"
#include "kernels/core/lane_ray.cl"

FUNCTION ray_x1 prepare_narrow(Ray ray, float extent) {
    return lane_ray(ray.origin, ray.direction, ray.t_max, major_axis(ray.direction), (int)RAY_SOURCE(ray.tag), extent);
}
