// Emissive shapes of instances: points of their own space in the world.
#pragma once
#include "generated/instances.cl"
#include "kernels/lights/emission.h"

/// Rows of lights of other kinds are evaluated too, and not selected: their numbers are kept within the array.
FUNCTION Placement place_of_light(Scene scene, Placement place) {
    return PLACEMENT(min(instance_number(place), scene.header->instances.count - 1u), place.time);
}

/// The lit point as the shape's space has it.
FUNCTION vec3 lit_point_in_group(Scene scene, Placement place, vec3 p) {
    const Transform to_group = transforms_of(scene, place_of_light(scene, place)).to_group;
    return where(instance_number(place) != 0u, transformed_point(to_group, p), p);
}

/// By M's cofactors, det(M) M⁻ᵀ, which take a normal times an area to the world (with the other sign where M mirrors).
FUNCTION vec3 area_in_world(Transform m, vec3 n) {
    return plus(scaled(cross3(m.y, m.z), n.x), plus(scaled(cross3(m.z, m.x), n.y), scaled(cross3(m.x, m.y), n.z)));
}

/// The root of the mean square, over all unit normals, of the area in the world that a unit area of the group's space has.
FUNCTION float mean_area_in_world(Transform m) {
    const vec3 x = cross3(m.y, m.z), y = cross3(m.z, m.x), z = cross3(m.x, m.y);
    return sqrt((dot3(x, x) + dot3(y, y) + dot3(z, z)) * (1.0f / 3.0f));
}

/// The area for which a unit area in the world with this unit normal n counts in the power by which its light is chosen. M = to_world at the time of
/// the place makes it of the area |Mᵀ n| / |det M| in the group's space, with a normal along Mᵀ n; in the power that has the area which to_world at
/// the first time makes of it, or on curved shapes makes of areas in the mean.
FUNCTION float emissive_area_in_power(Scene scene, Placement place, vec3 normal, bool flat) {
    const Placement known = place_of_light(scene, place);
    const Transform m = transforms_of(scene, known).to_world, first = load(&instance_record(scene, known)->to_world);
    const vec3 across = make3(dot3(m.x, normal), dot3(m.y, normal), dot3(m.z, normal)), area = area_in_world(first, across);
    const float volume = fabs(dot3(m.x, cross3(m.y, m.z)));
    const float counted = flat ? sqrt(dot3(area, area)) : mean_area_in_world(first) * sqrt(dot3(across, across));
    return instance_number(place) != 0u ? counted / volume : 1.0f;
}

/// For light at p. What may move the point off its surface, or the surface off it, counts along the normal n, in the group's space and in the world:
/// own errors, the way of a ray from p into the group's space, of at most 2^-21 (|M⁻¹| |w| + |origin|) for points w of the ray as surface_in_world
/// derives, and the point's way to the world, of at most 2^-22 (|M| |p| + |t|). Planes of the group at distance 1 are 1 / |M⁻ᵀ n| apart in the world.
FUNCTION EmissivePoint emissive_point_in_world(Scene scene, Placement place, vec3 p, EmissivePoint point) {
    const PlacedTransforms transforms = transforms_of(scene, place_of_light(scene, place));
    const Transform to_world = transforms.to_world, to_group = transforms.to_group;
    const vec3 q = transformed_point(to_world, point.p), reach = plus(absolute(q), absolute(minus(q, p)));
    const vec3 back = plus(error_in_world(to_group, reach), absolute(to_group.origin));
    const vec3 there = plus(error_in_world(to_world, absolute(point.p)), absolute(to_world.origin));
    const vec3 across = normal_in_world(to_group, point.normal), area = area_in_world(to_world, point.normal);
    const float apart = 1.0f / sqrt(dot3(across, across));
    const vec3 normal = scaled(across, apart);
    const vec3 on_the_way = with_mismatch(transforms, point.p, scaled(back, 0x1p-21f));
    const float in_group = point.error + dot3(absolute(point.normal), on_the_way);
    const bool moved = instance_number(place) != 0u;
    EmissivePoint world;
    world.p = where(moved, q, point.p);
    world.normal = where(moved, normal, point.normal);
    world.error = moved ? in_group * apart + 0x1p-22f * dot3(absolute(normal), there) : point.error;
    world.inverse_density = moved ? point.inverse_density * sqrt(dot3(area, area)) : point.inverse_density;
    return world;
}
