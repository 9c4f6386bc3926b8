// Counts of what a structure does for one ray.
#pragma once
#include "kernels/accelerators/work.h"

#define WORK_OF_RAY Work *work;
/// Adds to a counter of the ray's.
#define COUNT(ray, counter, n) (ray)->work->counter += (n)
/// Where the ray counts.
#define COUNT_IN(ray, sums) (ray).work = (sums)
/// In an instance the ray counts on.
#define SHARE_WORK(inner, ray) (inner).work = (ray)->work
