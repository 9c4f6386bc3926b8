// Every kind that Whitted's integrator can show, for lint and editors.
#pragma once
#include "kernels/bsdfs/whitted.cl"
#define FOR_EACH_WHITTED_BSDF(X) X(0, Whitted, whitted)
