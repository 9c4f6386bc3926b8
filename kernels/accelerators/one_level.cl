// Scenes without instances: all primitives are in the world, under one accelerator.
#pragma once
#include "kernels/accelerators/leaf.cl"

#define WORLD_KINDS(X) FOR_EACH_PRIMITIVE(X)
#define WORLD_CLOSEST_HIT block_closest_hit
#define WORLD_ANY_HIT block_any_hit

#define LEVEL(name) world_##name
#define LEVEL_KINDS WORLD_KINDS
#define LEAF_CLOSEST_HIT WORLD_CLOSEST_HIT
#define LEAF_ANY_HIT WORLD_ANY_HIT
#include "generated/accelerator.cl"
#undef LEVEL
#undef LEVEL_KINDS
#undef LEAF_CLOSEST_HIT
#undef LEAF_ANY_HIT
