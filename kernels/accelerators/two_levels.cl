// Scenes with instances: groups of primitives under accelerators of their own, and that of the world, whose leaves hold primitives or instances.
#pragma once
#include "kernels/accelerators/leaf.cl"

#define LEVEL(name) group_##name
#define LEVEL_KINDS(X) FOR_EACH_PRIMITIVE(X)
#define LEAF_CLOSEST_HIT block_closest_hit
#define LEAF_ANY_HIT block_any_hit
#include "generated/accelerator.cl"
#undef LEVEL
#undef LEVEL_KINDS
#undef LEAF_CLOSEST_HIT
#undef LEAF_ANY_HIT

#include "kernels/accelerators/instance_leaf.cl"

#define WORLD_KINDS(X) FOR_EACH_PRIMITIVE(X) X(INSTANCE_KIND, Instance, instance)
#define WORLD_CLOSEST_HIT world_block_closest_hit
#define WORLD_ANY_HIT world_block_any_hit

#define LEVEL(name) world_##name
#define LEVEL_KINDS WORLD_KINDS
#define LEAF_CLOSEST_HIT WORLD_CLOSEST_HIT
#define LEAF_ANY_HIT WORLD_ANY_HIT
#include "generated/accelerator.cl"
#undef LEVEL
#undef LEVEL_KINDS
#undef LEAF_CLOSEST_HIT
#undef LEAF_ANY_HIT
