// Instances in blocks, and the groups that they place.
#pragma once
#include "generated/constants.h"
#include "generated/instances.cl"
#include "kernels/core/rays.cl"
#include "kernels/core/scene.cl"

#include "kernels/core/lanes_8.cl"
#include "kernels/primitives/instance_hit.cl"

#include "kernels/core/lanes_1.cl"

FUNCTION const global InstanceBlock *instance_block(Scene scene, const global Group *group, uint block) {
    return RECORDS(scene, InstanceBlock, group->blocks[INSTANCE_KIND]) + block;
}

FUNCTION const global Group *group_of(Scene scene, uint instance) {
    return SCENE_ARRAY(scene, Group, groups) + SCENE_ARRAY(scene, Instance, instances)[instance].group;
}
