// One kind, which the self-test tries, for lint and editors.
#pragma once
#include "generated/primitives.cl"
#define NAME(function) sphere_##function
typedef SphereBlock Block;
