// Instances: rays in a group's space, and its surfaces in the world.
#pragma once
#include "kernels/core/items.h"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/load.cl"
#include "kernels/core/scene.cl"
#include "kernels/primitives/instance.h"
#include "kernels/primitives/surface.h"
#include "kernels/primitives/transform.cl"

/// A hit, and the instance that it is in.
typedef struct {
    Hit hit;
    uint instance;
} PlacedHit;
FUNCTION PlacedHit placed(Hit hit, uint instance) { return (PlacedHit){hit, instance}; }
FUNCTION uint instance_of(PlacedHit hit) { return hit.instance; }

/// Side arrays that only scenes with instances have: the instance of every hit, or of the primitive that every ray leaves.
FUNCTION uint instance_at(const global uint *instances, uint i) { return instances[i]; }
FUNCTION void store_instance(global uint *instances, uint i, uint instance) { instances[i] = instance; }

/// The direction is not made unit length: t stays the world's.
FUNCTION Ray ray_in_group(Scene scene, uint instance, Ray ray) {
    const global Transform *m = &(SCENE_ARRAY(scene, Instance, instances) + instance)->to_group;
    const vec3 origin = transformed_point(m, ray.origin), direction = transformed_direction(m, ray.direction);
    ray.origin = where(instance != 0u, origin, ray.origin);
    ray.direction = where(instance != 0u, direction, ray.direction);
    return ray;
}

/// Normals go by the inverse transposed, so that the outside stays the outside in a mirror too.
FUNCTION vec3 normal_in_world(const global Transform *to_group, vec3 n) {
    return make3(dot3(load(&to_group->x), n), dot3(load(&to_group->y), n), dot3(load(&to_group->z), n));
}

FUNCTION vec3 error_in_world(const global Transform *to_world, vec3 error) {
    return plus(scaled(absolute(load(&to_world->x)), error.x),
                plus(scaled(absolute(load(&to_world->y)), error.y), scaled(absolute(load(&to_world->z)), error.z)));
}

/// A transformed point has an error of at most 2^-22 of the sum of its terms' magnitudes. On the way to the world these are |M| |p| + |t|, where
/// |t| <= |w| + |M| |p| for the point w in the world; a ray that leaves from w comes back to the group's space by the inverse, whose coefficients
/// have 2^-24 of their own: less than 2^-21 (|M⁻¹| |w| + |origin|), which |M| brings to the world.
FUNCTION Surface surface_in_world(Scene scene, uint instance, Surface surface) {
    const global Instance *placed = SCENE_ARRAY(scene, Instance, instances) + instance;
    const global Transform *to_world = &placed->to_world, *to_group = &placed->to_group;
    const vec3 p = transformed_point(to_world, surface.p);
    const vec3 back = plus(error_in_world(to_group, absolute(p)), absolute(load(&to_group->origin)));
    const vec3 error = plus(surface.error, scaled(plus(absolute(surface.p), back), 0x1p-21f));
    const vec3 geometric = unit(normal_in_world(to_group, surface.geometric)), normal = unit(normal_in_world(to_group, surface.normal));
    const bool moved = instance != 0u;
    Surface world;
    world.p = where(moved, p, surface.p);
    world.error = where(moved, plus(error_in_world(to_world, error), scaled(absolute(p), 0x1p-22f)), surface.error);
    world.geometric = where(moved, geometric, surface.geometric);
    world.normal = where(moved, scaled(normal, dot3(normal, geometric) < 0.0f ? -1.0f : 1.0f), surface.normal);
    return world;
}

/// The material of a primitive in an instance.
FUNCTION uint material_in_instance(Scene scene, uint instance, uint material) {
    const uint all = SCENE_ARRAY(scene, Instance, instances)[instance].material;
    return all == NO_MATERIAL ? material : all;
}
