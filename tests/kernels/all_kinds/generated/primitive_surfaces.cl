// Every kind, for lint and editors.
#pragma once
#include "kernels/primitives/disk.cl"
#include "kernels/primitives/frustum.cl"
#include "kernels/primitives/smooth_triangle.cl"
#include "kernels/primitives/sphere.cl"
#include "kernels/primitives/triangle.cl"
