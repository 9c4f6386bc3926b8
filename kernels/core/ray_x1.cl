// A ray prepared for tracing in a tenth of the room of a ray_x8: for those who keep several, or have one lane.
#pragma once
#include "kernels/core/rays.cl"

#include "kernels/core/lanes_1.cl"
#include "kernels/core/lane_ray.cl"

FUNCTION ray_x1 prepare_narrow(Ray ray, float extent) {
    return lane_ray(ray.origin, ray.direction, ray.t_max, major_axis(ray.direction), (int)RAY_SOURCE(ray.tag), extent);
}

FUNCTION vec3x8 widened(vec3 v) { return make3((float8)(v.x), (float8)(v.y), (float8)(v.z)); }

/// The same ray, as prepare() gives it.
FUNCTION ray_x8 widened(const ray_x1 *ray) {
    ray_x8 wide;
    wide.origin = widened(ray->origin), wide.direction = widened(ray->direction), wide.t_max = (float8)(ray->t_max);
    wide.inverse_square = (float8)(ray->inverse_square);
    wide.source = (int8)(ray->source), wide.source_instance = (int8)(ray->source_instance);
    wide.pad = (float8)(ray->pad);
    wide.inverse = widened(ray->inverse), wide.shift_low = widened(ray->shift_low), wide.shift_high = widened(ray->shift_high);
    wide.turned_origin = widened(ray->turned_origin), wide.shear = widened(ray->shear);
    wide.kx = ray->kx, wide.ky = ray->ky, wide.kz = ray->kz;
    return wide;
}
