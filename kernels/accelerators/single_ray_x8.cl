// A ray that is traced alone has 8 lanes, each for another box or primitive: for CPUs, which have vectors.
#pragma once
#include "kernels/accelerators/primitive_hits_8.cl"

#define SINGLE_LANES 8u
typedef ray_x8 SingleRay;
typedef crossing_x8 SingleCrossing;

FUNCTION SingleRay prepare_single(Ray ray, float extent) { return prepare(ray, extent); }
FUNCTION void set_t_max(SingleRay *ray, float t_max) { ray->t_max = (float8)(t_max); }
FUNCTION void set_source_instance(SingleRay *ray, uint instance) { ray->source_instance = (int8)((int)instance); }
