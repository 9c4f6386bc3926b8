// What a ray meets in the scene, by the accelerator in use. An accelerator's file is a template, included once per level of the scene.
#pragma once
#include "generated/levels.cl"

/// `source`: where the primitive is which the ray leaves.
FUNCTION SingleRay prepare_in_world(const global Group *world, Ray ray, Placement source) {
    SingleRay prepared = prepare_single(ray, world->extent);
    if (INSTANCES) set_source_instance(&prepared, instance_number(source));
    SET_TIME(prepared, source.time);
    return prepared;
}

FUNCTION Nearest scene_closest_hit(Scene scene, Ray ray, Placement source) {
    const global Group *world = &scene.header->world;
    SingleRay prepared = prepare_in_world(world, ray, source);
    Nearest nearest = nothing_hit(ray, world->extent);
    SET_TIME(nearest, source.time);
    world_closest_hit(scene, world, &prepared, &nearest);
    return nearest;
}

/// Adds all hits up to the ray's t_max to the list; without a list, tells whether there is any.
FUNCTION bool scene_any_hit(Scene scene, Ray ray, Placement source, HitList *list) {
    const global Group *world = &scene.header->world;
    const SingleRay prepared = prepare_in_world(world, ray, source);
    if (list != 0) SET_TIME(*list, source.time);
    return world_any_hit(scene, world, &prepared, list);
}
