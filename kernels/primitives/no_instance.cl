// Stands for primitives/instance.cl in scenes without instances: everything is in the world, nothing is stored.
#pragma once
#include "kernels/core/items.h"
#include "kernels/core/scene.cl"
#include "kernels/primitives/surface.h"

typedef struct {
    Hit hit;
} PlacedHit;
FUNCTION PlacedHit placed(Hit hit, uint instance) { return (PlacedHit){hit}; }
FUNCTION uint instance_of(PlacedHit hit) { return 0u; }

FUNCTION uint instance_at(const global uint *instances, uint i) { return 0u; }
FUNCTION void store_instance(global uint *instances, uint i, uint instance) {}
FUNCTION Ray ray_in_group(Scene scene, uint instance, Ray ray) { return ray; }
FUNCTION Surface surface_in_world(Scene scene, uint instance, Surface surface) { return surface; }
FUNCTION uint material_in_instance(Scene scene, uint instance, uint material) { return material; }
