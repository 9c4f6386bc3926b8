// Emissive shapes of instances: points of their own space in the world.
#pragma once
#include "kernels/lights/emission.h"
#include "kernels/primitives/instance.cl"

/// Rows of lights of other kinds are evaluated too, and not selected: their numbers are kept within the array.
FUNCTION const global Instance *instance_of_light(Scene scene, uint instance) {
    return SCENE_ARRAY(scene, Instance, instances) + min(instance, scene.header->instances.count - 1u);
}

/// The lit point as the shape's space has it.
FUNCTION vec3 lit_point_in_group(Scene scene, uint instance, vec3 p) {
    const global Instance *placed = instance_of_light(scene, instance);
    return where(instance != 0u, transformed_point(&placed->to_group, p), p);
}

/// By M's cofactors, det(M) M⁻ᵀ, which take a normal times an area to the world (with the other sign where M mirrors).
FUNCTION vec3 area_in_world(const global Transform *m, vec3 n) {
    const vec3 x = load(&m->x), y = load(&m->y), z = load(&m->z);
    return plus(scaled(cross3(y, z), n.x), plus(scaled(cross3(z, x), n.y), scaled(cross3(x, y), n.z)));
}

/// The area in the group's space of a unit area in the world with this unit normal, which M = to_world stretches by |det M| / |Mᵀ n|.
FUNCTION float emissive_area_in_group(Scene scene, uint instance, vec3 normal) {
    const global Transform *m = &instance_of_light(scene, instance)->to_world;
    const vec3 x = load(&m->x), y = load(&m->y), z = load(&m->z);
    const vec3 stretched = make3(dot3(x, normal), dot3(y, normal), dot3(z, normal));
    const float volume = fabs(dot3(x, cross3(y, z)));
    return instance != 0u ? sqrt(dot3(stretched, stretched)) / volume : 1.0f;
}

/// For light at p. What may move the point off its surface, or the surface off it, counts along the normal n, in the group's space and in the world:
/// own errors, the way of a ray from p into the group's space, of at most 2^-21 (|M⁻¹| |w| + |origin|) for points w of the ray as surface_in_world
/// derives, and the point's way to the world, of at most 2^-22 (|M| |p| + |t|). Planes of the group at distance 1 are 1 / |M⁻ᵀ n| apart in the world.
FUNCTION EmissivePoint emissive_point_in_world(Scene scene, uint instance, vec3 p, EmissivePoint point) {
    const global Instance *placed = instance_of_light(scene, instance);
    const global Transform *to_world = &placed->to_world, *to_group = &placed->to_group;
    const vec3 q = transformed_point(to_world, point.p), reach = plus(absolute(q), absolute(minus(q, p)));
    const vec3 back = plus(error_in_world(to_group, reach), absolute(load(&to_group->origin)));
    const vec3 there = plus(error_in_world(to_world, absolute(point.p)), absolute(load(&to_world->origin)));
    const vec3 across = normal_in_world(to_group, point.normal), area = area_in_world(to_world, point.normal);
    const float apart = 1.0f / sqrt(dot3(across, across));
    const vec3 normal = scaled(across, apart);
    const float in_group = point.error + 0x1p-21f * dot3(absolute(point.normal), back);
    const bool moved = instance != 0u;
    EmissivePoint world;
    world.p = where(moved, q, point.p);
    world.normal = where(moved, normal, point.normal);
    world.error = moved ? in_group * apart + 0x1p-22f * dot3(absolute(normal), there) : point.error;
    world.inverse_density = moved ? point.inverse_density * sqrt(dot3(area, area)) : point.inverse_density;
    return world;
}
