// What filter_shadow_rays has found out: a side array of a Spectrum per shadow ray.
#pragma once
#include "kernels/core/load.cl"

/// The part of `light` that arrives along shadow ray k.
FUNCTION Spectrum filtered(Spectrum light, const global Spectrum *filters, uint k) { return times(light, load(filters + k)); }
