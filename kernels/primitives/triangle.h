/// Triangle with flat shading; both sides are visible, the outside is where its vertices run counterclockwise.
#pragma once
#include "kernels/core/scene.h"

typedef struct {
    uint primitive[BLOCK_SIZE];
    float a[3][BLOCK_SIZE], b[3][BLOCK_SIZE], c[3][BLOCK_SIZE];  ///< vertices, by axis
} TriangleBlock;

/// View of ShadingRecord.words.
typedef struct {
    vec3 a, b, c;
    uint uvs, colors;  ///< 1 + its entry in SceneHeader.vertex_uvs and .vertex_colors; 0: none
} TriangleShading;

/// Texture coordinates of a triangle's vertices.
typedef struct {
    vec2 a, b, c;
} VertexUvs;

/// Colours of a triangle's vertices.
typedef struct {
    Spectrum a, b, c;
} VertexColors;
