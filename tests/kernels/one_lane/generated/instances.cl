// At rest, for lint.
#pragma once
#include "kernels/primitives/instance.cl"
