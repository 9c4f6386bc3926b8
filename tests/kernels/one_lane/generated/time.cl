// At rest, for lint.
#pragma once
#include "kernels/core/no_time.cl"
