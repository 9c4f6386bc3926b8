// Transforms of one point or direction.
#pragma once
#include "kernels/core/lanes_1.cl"
#include "kernels/primitives/transform.h"
#include "kernels/primitives/transform.cl"
