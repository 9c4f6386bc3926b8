// Template, included once per level: see cells.cl, which tests what kd_tree_walk.cl comes to.
#include "kernels/accelerators/kd_tree_walk.cl"

#include "kernels/accelerators/cells.cl"
