// Rays, boxes and crossings of 8 and of 16 lanes.
#pragma once

#include "kernels/core/lanes_8.cl"
#define LaneRay ray_x8
#define LaneBox box_x8
#define Crossing crossing_x8
#include "kernels/core/lane_ray.cl"
#undef LaneRay
#undef LaneBox
#undef Crossing

#include "kernels/core/lanes_16.cl"
#define LaneRay ray_x16
#define LaneBox box_x16
#define Crossing crossing_x16
#include "kernels/core/lane_ray.cl"
#undef LaneRay
#undef LaneBox
#undef Crossing
