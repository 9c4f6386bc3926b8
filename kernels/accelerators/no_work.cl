// Stands for accelerators/work.cl wherever nobody counts, which is in all renders.
#pragma once

#define WORK_OF_RAY
#define COUNT(ray, counter, n) ((void)0)
#define COUNT_IN(ray, sums) ((void)0)
#define SHARE_WORK(inner, ray)
