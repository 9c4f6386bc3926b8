// What a ray meets in the scene, by the accelerator in use. An accelerator's file is a template, included once per level of the scene.
#pragma once
#include "generated/levels.cl"

/// `source_instance`: that of the primitive which the ray leaves.
FUNCTION ray_x8 prepare_in_world(const global Group *world, Ray ray, uint source_instance) {
    ray_x8 lanes = prepare(ray, world->extent);
    if (INSTANCES) lanes.source_instance = (int8)((int)source_instance);
    return lanes;
}

FUNCTION Nearest scene_closest_hit(Scene scene, Ray ray, uint source_instance) {
    const global Group *world = &scene.header->world;
    ray_x8 lanes = prepare_in_world(world, ray, source_instance);
    Nearest nearest = nothing_hit(&lanes);
    world_closest_hit(scene, world, &lanes, &nearest);
    return nearest;
}

/// Adds all hits up to the ray's t_max to the list; without a list, tells whether there is any.
FUNCTION bool scene_any_hit(Scene scene, Ray ray, uint source_instance, HitList *list) {
    const global Group *world = &scene.header->world;
    const ray_x8 lanes = prepare_in_world(world, ray, source_instance);
    return world_any_hit(scene, world, &lanes, list);
}
