// With everything, for lint and editors.
#pragma once
#include "kernels/core/time.cl"
