// A ray that is traced alone has one lane, for one box or primitive after another: for GPUs, on which it is a lane itself.
#pragma once
#include "generated/primitives.cl"
#include "kernels/core/ray_x1.cl"

#include "kernels/core/lanes_1.cl"
#include "generated/primitive_hits.cl"

#define SINGLE_LANES 1u
typedef ray_x1 SingleRay;
typedef crossing_x1 SingleCrossing;

FUNCTION SingleRay prepare_single(Ray ray, float extent) { return prepare_narrow(ray, extent); }
FUNCTION void set_t_max(SingleRay *ray, float t_max) { ray->t_max = t_max; }
FUNCTION void set_source_instance(SingleRay *ray, uint instance) { ray->source_instance = (int)instance; }
