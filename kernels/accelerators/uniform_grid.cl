// Template, included once per level: see cells.cl, which tests what uniform_grid_walk.cl comes to.
#include "kernels/accelerators/uniform_grid_walk.cl"

#include "kernels/accelerators/cells.cl"
