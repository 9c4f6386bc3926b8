// With everything, for lint and editors.
#pragma once
#include "kernels/bsdfs/losses.cl"
