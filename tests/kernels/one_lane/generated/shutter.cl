// At rest, for lint.
#pragma once
#include "kernels/cameras/no_shutter.cl"
