// Rays in a group's space, and its surfaces in the world. The includer has defined Placement and what transforms belong to one.
#include "kernels/core/items.h"
#include "kernels/core/lanes_1.cl"
#include "kernels/primitives/surface.h"
#include "kernels/primitives/transform_x1.cl"

/// A hit, and where it is.
typedef struct {
    Hit hit;
    Placement place;
} PlacedHit;
FUNCTION PlacedHit placed(Hit hit, Placement place) { return (PlacedHit){hit, place}; }
FUNCTION Placement place_of(PlacedHit hit) { return hit.place; }
FUNCTION uint instance_of(PlacedHit hit) { return instance_number(hit.place); }

/// The direction is not made unit length: t stays the world's.
FUNCTION Ray ray_in_group(PlacedTransforms transforms, Ray ray) {
    const vec3 origin = transformed_point(transforms.to_group, ray.origin), direction = transformed_direction(transforms.to_group, ray.direction);
    ray.origin = where(transforms.instance != 0u, origin, ray.origin);
    ray.direction = where(transforms.instance != 0u, direction, ray.direction);
    return ray;
}
FUNCTION Ray ray_in_group(Scene scene, Placement place, Ray ray) { return ray_in_group(transforms_of(scene, place), ray); }

/// Normals go by the inverse transposed, so that the outside stays the outside in a mirror too.
FUNCTION vec3 normal_in_world(Transform to_group, vec3 n) { return make3(dot3(to_group.x, n), dot3(to_group.y, n), dot3(to_group.z, n)); }

FUNCTION vec3 error_in_world(Transform to_world, vec3 error) {
    return plus(scaled(absolute(to_world.x), error.x), plus(scaled(absolute(to_world.y), error.y), scaled(absolute(to_world.z), error.z)));
}

/// A transformed point has an error of at most 2^-22 of the sum of its terms' magnitudes. On the way to the world these are |M| |p| + |t|, where
/// |t| <= |w| + |M| |p| for the point w in the world; a ray that leaves from w comes back to the group's space by the inverse, whose coefficients
/// have 2^-24 of their own: less than 2^-21 (|M⁻¹| |w| + |origin|), which |M| brings to the world.
FUNCTION Surface surface_in_world(PlacedTransforms transforms, Surface surface) {
    const Transform to_world = transforms.to_world, to_group = transforms.to_group;
    const vec3 p = transformed_point(to_world, surface.p);
    const vec3 back = plus(error_in_world(to_group, absolute(p)), absolute(to_group.origin));
    const vec3 rounded = plus(surface.error, scaled(plus(absolute(surface.p), back), 0x1p-21f));
    const vec3 error = with_mismatch(transforms, surface.p, rounded);
    const vec3 geometric = unit(normal_in_world(to_group, surface.geometric)), normal = unit(normal_in_world(to_group, surface.normal));
    const bool moved = transforms.instance != 0u;
    Surface world;
    world.p = where(moved, p, surface.p);
    world.error = where(moved, plus(error_in_world(to_world, error), scaled(absolute(p), 0x1p-22f)), surface.error);
    world.geometric = where(moved, geometric, surface.geometric);
    world.normal = where(moved, scaled(normal, dot3(normal, geometric) < 0.0f ? -1.0f : 1.0f), surface.normal);
    world.lift = where(moved, transformed_direction(to_world, surface.lift), surface.lift);
    return world;
}

FUNCTION Surface surface_in_world(Scene scene, Placement place, Surface surface) { return surface_in_world(transforms_of(scene, place), surface); }

/// The material of a primitive in an instance.
FUNCTION uint material_in_instance(Scene scene, Placement place, uint material) {
    const uint all = instance_record(scene, place)->material;
    return all == NO_MATERIAL ? material : all;
}
