// One that does not see everywhere, for lint and editors.
#pragma once
#include "kernels/cameras/fisheye.cl"
