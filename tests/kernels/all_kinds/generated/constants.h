// With everything, for lint and editors.
#pragma once
#define BRANCHING 2u
#define INTERIOR_SIZE 4u
#define HIGHLIGHTS 1
#define SHADING_NORMALS 1
