// Packets in scenes with instances: groups of primitives under accelerators of their own, and that of the world, whose leaves hold primitives or
// instances.
#pragma once
#include "kernels/accelerators/packet_leaf.cl"

#define LEVEL(name) group_##name
#define LEVEL_KINDS(X) FOR_EACH_PRIMITIVE(X)
#define LEAF_CLOSEST_HITS block_closest_hits
#define LEAF_ENDS_RAYS block_ends_rays
#include "generated/packet_accelerator.cl"
#undef LEVEL
#undef LEVEL_KINDS
#undef LEAF_CLOSEST_HITS
#undef LEAF_ENDS_RAYS

#include "kernels/accelerators/packet_instance_leaf.cl"

#define LEVEL(name) world_##name
#define LEVEL_KINDS(X) FOR_EACH_PRIMITIVE(X) X(INSTANCE_KIND, Instance, instance)
#define LEAF_CLOSEST_HITS world_block_closest_hits
#define LEAF_ENDS_RAYS world_block_ends_rays
#include "generated/packet_accelerator.cl"
#undef LEVEL
#undef LEVEL_KINDS
#undef LEAF_CLOSEST_HITS
#undef LEAF_ENDS_RAYS
