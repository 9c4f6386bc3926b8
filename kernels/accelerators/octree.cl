// Template, included once per level: see cells.cl, which tests what octree_walk.cl comes to.
#include "kernels/accelerators/octree_walk.cl"

#include "kernels/accelerators/cells.cl"
