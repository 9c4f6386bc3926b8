// Where things are, in scenes at rest: in which instance.
#pragma once
#include "kernels/core/portable.h"

/// Number of an instance, 0 outside of all.
typedef uint Placement;
#define PLACEMENT(instance, time) (instance)
FUNCTION uint instance_number(Placement place) { return place; }
