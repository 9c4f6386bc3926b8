// Packets in scenes without instances: all primitives are in the world, under one accelerator.
#pragma once
#include "kernels/accelerators/packet_leaf.cl"

#define LEVEL(name) world_##name
#define LEVEL_KINDS(X) FOR_EACH_PRIMITIVE(X)
#define LEAF_CLOSEST_HITS block_closest_hits
#define LEAF_ENDS_RAYS block_ends_rays
#include "generated/packet_accelerator.cl"
#undef LEVEL
#undef LEVEL_KINDS
#undef LEAF_CLOSEST_HITS
#undef LEAF_ENDS_RAYS
