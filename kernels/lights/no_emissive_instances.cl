// Stands for lights/emissive_instances.cl in scenes where no emissive shape is in an instance.
#pragma once
#include "generated/instances.cl"
#include "kernels/core/scene.cl"
#include "kernels/lights/emission.h"

FUNCTION vec3 lit_point_in_group(Scene scene, Placement place, vec3 p) { return p; }
FUNCTION float emissive_area_in_power(Scene scene, Placement place, vec3 normal, bool flat) { return 1.0f; }
FUNCTION EmissivePoint emissive_point_in_world(Scene scene, Placement place, vec3 p, EmissivePoint point) { return point; }
