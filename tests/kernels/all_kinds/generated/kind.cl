// One kind, which the self-test tries, for lint and editors.
#pragma once
#include "generated/primitives.cl"
#define NAME(function) sphere_##function
#define HAS_VERTICES 0
typedef SphereBlock Block;
