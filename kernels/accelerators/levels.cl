// What a ray meets in the scene, by the accelerator in use. An accelerator's file is a template, included once per level of the scene.
#pragma once
#include "generated/levels.cl"

/// `source_instance`: that of the primitive which the ray leaves.
FUNCTION SingleRay prepare_in_world(const global Group *world, Ray ray, uint source_instance) {
    SingleRay prepared = prepare_single(ray, world->extent);
    if (INSTANCES) set_source_instance(&prepared, source_instance);
    return prepared;
}

FUNCTION Nearest scene_closest_hit(Scene scene, Ray ray, uint source_instance) {
    const global Group *world = &scene.header->world;
    SingleRay prepared = prepare_in_world(world, ray, source_instance);
    Nearest nearest = nothing_hit(ray, world->extent);
    world_closest_hit(scene, world, &prepared, &nearest);
    return nearest;
}

/// Adds all hits up to the ray's t_max to the list; without a list, tells whether there is any.
FUNCTION bool scene_any_hit(Scene scene, Ray ray, uint source_instance, HitList *list) {
    const global Group *world = &scene.header->world;
    const SingleRay prepared = prepare_in_world(world, ray, source_instance);
    return world_any_hit(scene, world, &prepared, list);
}
