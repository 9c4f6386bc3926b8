// With everything, for lint and editors.
#pragma once
#include "kernels/primitives/instance.cl"
