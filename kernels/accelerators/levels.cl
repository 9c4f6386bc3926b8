// The accelerator in use, as functions of the scene.
// An accelerator's file is a template, so that it can be included again for groups of primitives with another set of LEAF_ macros.
#pragma once
#include "kernels/accelerators/leaf.cl"

#define LEVEL(name) world_##name
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

FUNCTION Nearest scene_closest_hit(Scene scene, Ray ray) {
    const global Group *world = &scene.header->world;
    ray_x8 lanes = prepare(ray, world->extent);
    Nearest nearest = nothing_hit(&lanes);
    world_closest_hit(scene, world, &lanes, &nearest);
    return nearest;
}

/// Adds all hits up to the ray's t_max to the list; without a list, tells whether there is any.
FUNCTION bool scene_any_hit(Scene scene, Ray ray, HitList *list) {
    const global Group *world = &scene.header->world;
    const ray_x8 lanes = prepare(ray, world->extent);
    return world_any_hit(scene, world, &lanes, list);
}

FUNCTION PacketHits scene_closest_hits(Scene scene, const Packet *packet) {
    const global Group *world = &scene.header->world;
    PacketHits closest = packet_without_hits(packet, world->extent);
    for (uint axis = 0u; axis < 3u; ++axis) {
        const int16 lanes = packet_lanes(packet, axis);
        if (mask_bits(lanes) == 0u) continue;
        PacketRays rays = packet_rays(packet, axis, world->extent, lanes);
        world_closest_hits(scene, world, &rays, &closest);
    }
    return closest;
}

/// The packet's rays that meet something before their t_max.
FUNCTION int16 scene_occluded(Scene scene, const Packet *packet) {
    const global Group *world = &scene.header->world;
    int16 occluded = (int16)(0);
    for (uint axis = 0u; axis < 3u; ++axis) {
        const int16 lanes = packet_lanes(packet, axis);
        if (mask_bits(lanes) == 0u) continue;
        PacketRays rays = packet_rays(packet, axis, world->extent, lanes);
        world_end_occluded(scene, world, &rays);
        occluded |= lanes & (rays.rays.t_max < 0.0f);
    }
    return occluded;
}
