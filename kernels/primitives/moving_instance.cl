// Instances some of which move: where things are depends on the time of the path that sees them.
#pragma once
#include "kernels/core/items.cl"
#include "kernels/core/scene.cl"
#include "kernels/primitives/instance.h"
#include "kernels/primitives/load_transform.cl"
#include "kernels/primitives/motion.cl"
#include "kernels/primitives/transform_x1.cl"

/// Number of an instance, 0 outside of all, and a time.
typedef struct {
    uint instance;
    float time;
} Placement;
#define PLACEMENT(instance, time) ((Placement){instance, time})
FUNCTION uint instance_number(Placement place) { return place.instance; }

/// Side arrays: the instance of every hit, or of the primitive that every ray leaves, and the time.
FUNCTION Placement instance_at(const global uint *instances, uint i) { return PLACEMENT(instances[2u * i], as_float(instances[2u * i + 1u])); }
FUNCTION void store_instance(global uint *instances, uint i, Placement place) {
    instances[2u * i] = place.instance, instances[2u * i + 1u] = as_uint(place.time);
}

FUNCTION const global Instance *instance_record(Scene scene, Placement place) { return SCENE_ARRAY(scene, Instance, instances) + place.instance; }

/// What leads from the group's space to the world, and back, which brings a point that far from where it was at most.
typedef struct {
    uint instance;
    Transform to_world, to_group, mismatch;
} PlacedTransforms;

FUNCTION PlacedTransforms transforms_of(Scene scene, Placement place) {
    const global Instance *instance = instance_record(scene, place);
    const Transform none = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}};
    PlacedTransforms result;
    result.instance = place.instance;
    result.to_world = load(&instance->to_world), result.to_group = load(&instance->to_group), result.mismatch = none;
    if (instance->parts == 0u) return result;
    const MotionPlace motion = place_in_motion(SCENE_ARRAY(scene, MotionPart, motion_parts) + instance->first_part, instance->parts, place.time);
    result.to_world = transform_at(motion.part->to_world, motion.s), result.to_group = transform_at(motion.part->to_group, motion.s);
    result.mismatch = load(&motion.part->mismatch);
    return result;
}

/// An error bound of p in the group's space, and what comes to it because the transforms are not quite inverse to each other, beyond their rounding.
FUNCTION vec3 with_mismatch(PlacedTransforms transforms, vec3 p, vec3 error) {
    return plus(error, transformed_point(transforms.mismatch, absolute(p)));
}

/// Of the places of a chunk, word by word: found one after another, so that loops which need them can be 16 wide.
typedef struct {
    uint instances[ITEMS_PER_WORK_ITEM];
    float words[36][ITEMS_PER_WORK_ITEM];
} PlaceColumns;

FUNCTION void fetch_places(Scene scene, const global uint *instances, Chunk chunk, PlaceColumns *columns) {
    for (uint c = 0u; c < chunk.items; ++c) {
        const PlacedTransforms transforms = transforms_of(scene, instance_at(instances, chunk.begin + c));
        const float *words = (const float *)&transforms.to_world;
        columns->instances[c] = transforms.instance;
        for (uint w = 0u; w < 36u; ++w) columns->words[w][c] = words[w];
    }
}

#define COLUMN_VECTOR(columns, first, c) make3((columns)->words[first][c], (columns)->words[(first) + 1u][c], (columns)->words[(first) + 2u][c])
FUNCTION Transform transform_of_columns(const PlaceColumns *columns, uint first, uint c) {
    Transform m;
    m.x = COLUMN_VECTOR(columns, first, c), m.y = COLUMN_VECTOR(columns, first + 3u, c), m.z = COLUMN_VECTOR(columns, first + 6u, c);
    m.origin = COLUMN_VECTOR(columns, first + 9u, c);
    return m;
}
#undef COLUMN_VECTOR

FUNCTION PlacedTransforms transforms_of_columns(Scene scene, const global uint *instances, uint i, const PlaceColumns *columns, uint c) {
    PlacedTransforms result;
    result.instance = columns->instances[c];
    result.to_world = transform_of_columns(columns, 0u, c), result.to_group = transform_of_columns(columns, 12u, c);
    result.mismatch = transform_of_columns(columns, 24u, c);
    return result;
}

#include "kernels/primitives/instance_space.cl"
