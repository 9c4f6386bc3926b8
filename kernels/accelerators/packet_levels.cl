// What packets of rays meet in the scene, by the accelerator in use: those that trace packets have a template for them too.
#pragma once
#include "generated/packet_levels.cl"

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
