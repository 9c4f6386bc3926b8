// What packets of rays meet in the scene, by the accelerator in use: those that trace packets have a template for them too.
#pragma once
#include "generated/packet_levels.cl"

FUNCTION PacketHits scene_closest_hits(Scene scene, const Packet *packet) {
    const global Group *world = &scene.header->world;
    PacketHits closest = packet_without_hits(packet, world->extent);
    for (uint axis = 0u; axis < 3u; ++axis) {
        if (!any_along(packet, axis)) continue;
        PacketRays rays = packet_rays(packet, axis, world->extent);
        world_closest_hits(scene, world, &rays, &closest);
    }
    return closest;
}

/// Bits of the rays of each row that meet something before their t_max.
FUNCTION void scene_occluded(Scene scene, const Packet *packet, uint *occluded) {
    const global Group *world = &scene.header->world;
    FOR_EACH_ROW(r) occluded[r] = 0u;
    for (uint axis = 0u; axis < 3u; ++axis) {
        if (!any_along(packet, axis)) continue;
        PacketRays rays = packet_rays(packet, axis, world->extent);
        uint alive[ROWS];
        FOR_EACH_ROW(r) alive[r] = mask_bits(rays.rows[r].t_max >= 0.0f);
        world_end_occluded(scene, world, &rays);
        FOR_EACH_ROW(r) occluded[r] |= alive[r] & mask_bits(rays.rows[r].t_max < 0.0f);
    }
}
