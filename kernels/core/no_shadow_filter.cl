// Stands for core/shadow_filter.cl where shadows are opaque: light arrives or not, nothing is stored.
#pragma once
#include "kernels/core/lanes_1.cl"

FUNCTION Spectrum filtered(Spectrum light, const global Spectrum *filters, uint k) { return light; }
