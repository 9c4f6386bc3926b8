// With everything, for lint and editors.
#pragma once
#define BRANCHING 2u
#define TRANSMITS 1
#define FOLLOWS_ONE 0
#define INTERIOR_SIZE 4u
#define HIGHLIGHTS 1
#define SHADING_NORMALS 1
#define PATHS 1
#define INSTANCES 1
#define INSTANCES_MOVE 1
#define LIGHTS 1
#define BUNDLES 1
#define ONE_BSDF 0
#define CHOOSES 1
#define FACETS 3u
#define INSTANCE_KIND 5u
#define FLAT_KINDS 0x16u
