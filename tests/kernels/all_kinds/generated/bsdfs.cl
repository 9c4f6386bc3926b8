// Every kind, for lint and editors.
#pragma once
#include "kernels/bsdfs/whitted.cl"
#define FOR_EACH_BSDF(X) X(0, Whitted, whitted)
