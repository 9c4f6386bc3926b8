// One that uses the table, for lint and editors.
#pragma once
#include "kernels/filters/tabulated.cl"
