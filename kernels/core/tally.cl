// Counts of rays and hits.
#pragma once
#include "kernels/core/items.h"

/// To what the launches before have left there.
FUNCTION void add_tally(global Tally *sum, Tally tally) {
    for (uint kind = 0u; kind < RAY_KINDS; ++kind) sum->rays[kind] += tally.rays[kind], sum->hits[kind] += tally.hits[kind];
}
