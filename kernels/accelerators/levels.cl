// The accelerator in use, as functions of the scene: scene_closest_hit, scene_any_hit and their packet forms.
// An accelerator's file is a template, so that it can be included again for groups of primitives with another set of LEAF_ macros.
#pragma once
#include "kernels/accelerators/leaf.cl"

#define LEVEL(name) scene_##name
#define LEAF_CLOSEST_HIT block_closest_hit
#define LEAF_ANY_HIT block_any_hit
#define LEAF_CLOSEST_HITS block_closest_hits
#define LEAF_ENDS_RAYS block_ends_rays
#include "generated/accelerator.cl"
#undef LEVEL
#undef LEAF_CLOSEST_HIT
#undef LEAF_ANY_HIT
#undef LEAF_CLOSEST_HITS
#undef LEAF_ENDS_RAYS
