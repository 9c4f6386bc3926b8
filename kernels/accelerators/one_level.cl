// Scenes without instances: all primitives are in the world, under one accelerator.
#pragma once
#include "kernels/accelerators/leaf.cl"

#define LEVEL(name) world_##name
#define LEVEL_KINDS(X) FOR_EACH_PRIMITIVE(X)
#define LEAF_CLOSEST_HIT block_closest_hit
#define LEAF_ANY_HIT block_any_hit
#include "generated/accelerator.cl"
#undef LEVEL
#undef LEVEL_KINDS
#undef LEAF_CLOSEST_HIT
#undef LEAF_ANY_HIT
