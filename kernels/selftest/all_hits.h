/// What a ray meets in a scene, in all.
#pragma once
#include "kernels/accelerators/hit_list.h"
#include "kernels/core/portable.h"

/// Numbers of primitives, NO_HIT for none.
typedef struct {
    uint closest;             ///< as the search for the closest hit alone has it
    uint all[HIT_LIST_SIZE];  ///< in the order of (t, instance, primitive)
} MetPrimitives;
