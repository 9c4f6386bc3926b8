// Every kind, for lint and editors.
#pragma once
#include "kernels/primitives/disk.h"
#include "kernels/primitives/frustum.h"
#include "kernels/primitives/smooth_triangle.h"
#include "kernels/primitives/sphere.h"
#include "kernels/primitives/triangle.h"
#define FOR_EACH_PRIMITIVE(X) \
    X(0, Sphere, sphere) X(1, Triangle, triangle) X(2, SmoothTriangle, smooth_triangle) X(3, Frustum, frustum) X(4, Disk, disk)
