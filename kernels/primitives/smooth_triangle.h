/// Triangle whose shading normal is interpolated between its vertices.
#pragma once
#include "kernels/primitives/triangle.h"

typedef TriangleBlock SmoothTriangleBlock;

/// View of ShadingRecord.words.
typedef struct {
    TriangleShading flat;
    uint normals;  ///< its entry in SceneHeader.vertex_normals
} SmoothTriangleShading;

typedef struct {
    vec3 a, b, c;  ///< unit length
} VertexNormals;
