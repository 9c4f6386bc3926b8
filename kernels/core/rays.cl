// Rays, boxes and crossings of 8 lanes: one ray prepared for 8 primitives at a time.
#pragma once

#include "kernels/core/lanes_8.cl"
#include "kernels/core/lane_ray.cl"

#include "kernels/core/items.h"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/major_axis.cl"

FUNCTION ray_x8 prepare(Ray ray, float extent) {
    const vec3x8 origin = make3((float8)(ray.origin.x), (float8)(ray.origin.y), (float8)(ray.origin.z));
    const vec3x8 direction = make3((float8)(ray.direction.x), (float8)(ray.direction.y), (float8)(ray.direction.z));
    return lane_ray(origin, direction, (float8)(ray.t_max), major_axis(ray.direction), (int8)((int)RAY_SOURCE(ray.tag)), extent);
}
