// Crossings of one ray with blocks of 8 primitives, for every kind in use.
#pragma once
#include "generated/primitives.cl"
#include "kernels/core/rays.cl"

#include "kernels/core/lanes_8.cl"
#include "generated/primitive_hits.cl"

#include "kernels/core/lanes_1.cl"
