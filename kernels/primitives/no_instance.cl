// Stands for primitives/instance.cl in scenes without instances: everything is in the world, nothing is stored.
#pragma once
#include "kernels/core/items.cl"
#include "kernels/core/scene.cl"
#include "kernels/primitives/placement.cl"
#include "kernels/primitives/surface.h"

typedef struct {
    Hit hit;
} PlacedHit;
FUNCTION PlacedHit placed(Hit hit, Placement place) { return (PlacedHit){hit}; }
FUNCTION Placement place_of(PlacedHit hit) { return 0u; }
FUNCTION uint instance_of(PlacedHit hit) { return 0u; }

FUNCTION Placement instance_at(const global uint *instances, uint i) { return 0u; }
FUNCTION void store_instance(global uint *instances, uint i, Placement place) {}
typedef uint PlacedTransforms;
typedef uint PlaceColumns;
FUNCTION void fetch_places(Scene scene, const global uint *instances, Chunk chunk, PlaceColumns *columns) {}
FUNCTION PlacedTransforms transforms_of_columns(Scene scene, const global uint *instances, uint i, const PlaceColumns *columns, uint c) { return 0u; }

FUNCTION Ray ray_in_group(PlacedTransforms transforms, Ray ray) { return ray; }
FUNCTION Ray ray_in_group(Scene scene, Placement place, Ray ray) { return ray; }
FUNCTION Surface surface_in_world(PlacedTransforms transforms, Surface surface) { return surface; }
FUNCTION Surface surface_in_world(Scene scene, Placement place, Surface surface) { return surface; }
FUNCTION uint material_in_instance(Scene scene, Placement place, uint material) { return material; }
