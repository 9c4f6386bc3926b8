// AOV: which instance of a group is hit.
#pragma once
#include "generated/instances.cl"

/// From 1 on, in the order of the scene; 0 where nothing is hit, and outside of all.
FUNCTION uint aov_number(PlacedHit hit) { return instance_of(hit); }
#include "kernels/aovs/record_number.cl"
