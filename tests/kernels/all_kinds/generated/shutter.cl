// With everything, for lint and editors.
#pragma once
#include "kernels/cameras/shutter.cl"
