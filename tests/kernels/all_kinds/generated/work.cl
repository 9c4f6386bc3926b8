// As in renders, for lint and editors.
#pragma once
#include "kernels/accelerators/no_work.cl"
