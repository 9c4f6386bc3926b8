// AOV: which primitive is hit.
#pragma once
#include "generated/instances.cl"

/// From 1 on, in the order of the scene; 0 where nothing is hit.
FUNCTION uint aov_number(PlacedHit hit) { return hit.hit.primitive + 1u; }
#include "kernels/aovs/record_number.cl"
