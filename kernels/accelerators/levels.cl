// The accelerator in use, as functions of the scene: scene_closest_hit, scene_occluded, and their packet forms.
// An accelerator's file is a template, so that it can be included again for groups of primitives with another set of LEAF_ macros.
#pragma once
#include "kernels/accelerators/leaf.cl"

#define LEVEL(name) scene_##name
#define LEAF_CLOSEST_HIT block_closest_hit
#define LEAF_OCCLUDES block_occludes
#define LEAF_CLOSEST_HITS block_closest_hits
#define LEAF_ENDS_RAYS block_ends_rays
#include "generated/accelerator.cl"
#undef LEVEL
#undef LEAF_CLOSEST_HIT
#undef LEAF_OCCLUDES
#undef LEAF_CLOSEST_HITS
#undef LEAF_ENDS_RAYS

/// Rays first .. first + 15 of a list, lane by lane; lanes beyond `last` repeat the last ray and have t_max -1.
typedef struct {
    float origin[3][PACKET], direction[3][PACKET], t_max[PACKET];
    int axis[PACKET];  ///< of the largest component of the direction
} Packet;

FUNCTION Packet packet_of(const global Ray *rays, const global uint *live, uint first, uint last) {
    Packet packet;
    for (uint j = 0u; j < PACKET; ++j) {
        const Ray ray = rays[live[min(first + j, last - 1u)]];
        packet.origin[0][j] = ray.origin.x, packet.origin[1][j] = ray.origin.y, packet.origin[2][j] = ray.origin.z;
        packet.direction[0][j] = ray.direction.x, packet.direction[1][j] = ray.direction.y, packet.direction[2][j] = ray.direction.z;
        packet.t_max[j] = first + j < last ? ray.t_max : -1.0f;
        packet.axis[j] = (int)major_axis(ray.direction);
    }
    return packet;
}

/// The packet's rays whose direction is largest along `axis`; the others have t_max -1. Their bits are in `lanes`.
FUNCTION ray_x16 packet_rays(const Packet *packet, uint axis, float extent, int16 *lanes) {
    *lanes = vload16(0, packet->axis) == (int16)((int)axis);
    const vec3x16 origin = make3(vload16(0, packet->origin[0]), vload16(0, packet->origin[1]), vload16(0, packet->origin[2]));
    const vec3x16 direction = make3(vload16(0, packet->direction[0]), vload16(0, packet->direction[1]), vload16(0, packet->direction[2]));
    return lane_ray(origin, direction, *lanes ? vload16(0, packet->t_max) : (float16)(-1.0f), axis, extent);
}
