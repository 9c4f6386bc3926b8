// Instances at rest.
#pragma once
#include "kernels/core/items.cl"
#include "kernels/core/scene.cl"
#include "kernels/primitives/instance.h"
#include "kernels/primitives/load_transform.cl"
#include "kernels/primitives/placement.cl"

/// Side arrays that only scenes with instances have: the instance of every hit, or of the primitive that every ray leaves.
FUNCTION Placement instance_at(const global uint *instances, uint i) { return instances[i]; }
FUNCTION void store_instance(global uint *instances, uint i, Placement place) { instances[i] = place; }

FUNCTION const global Instance *instance_record(Scene scene, Placement place) { return SCENE_ARRAY(scene, Instance, instances) + place; }
/// What leads from the group's space to the world, and back.
typedef struct {
    uint instance;
    Transform to_world, to_group;
} PlacedTransforms;

FUNCTION PlacedTransforms transforms_of(Scene scene, Placement place) {
    PlacedTransforms result;
    result.instance = place;
    result.to_world = load(&instance_record(scene, place)->to_world), result.to_group = load(&instance_record(scene, place)->to_group);
    return result;
}

/// An error bound of p in the group's space, and what comes to it because the transforms are not quite inverse to each other, beyond their rounding.
FUNCTION vec3 with_mismatch(PlacedTransforms transforms, vec3 p, vec3 error) { return error; }

/// Of the places of a chunk: where nothing moves they are read as they are needed.
typedef uint PlaceColumns;
FUNCTION void fetch_places(Scene scene, const global uint *instances, Chunk chunk, PlaceColumns *columns) {}
FUNCTION PlacedTransforms transforms_of_columns(Scene scene, const global uint *instances, uint i, const PlaceColumns *columns, uint c) {
    return transforms_of(scene, instance_at(instances, i));
}

#include "kernels/primitives/instance_space.cl"
