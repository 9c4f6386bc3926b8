// Smooth triangle: the surface at a hit.
#pragma once
#include "kernels/core/load.cl"
#include "kernels/primitives/smooth_triangle.h"
#include "kernels/primitives/triangle.cl"

/// The shading normal is the interpolated one, on the geometric normal's side.
FUNCTION Surface smooth_triangle_surface(Scene scene, ShadingRecord record, Ray ray, Hit hit) {
    Surface surface = triangle_surface(scene, record, ray, hit);
    const global VertexNormals *normals = SCENE_ARRAY(scene, VertexNormals, vertex_normals) + record.words[11];
    const vec3 n = plus(scaled(load(&normals->a), 1.0f - hit.u - hit.v), plus(scaled(load(&normals->b), hit.u), scaled(load(&normals->c), hit.v)));
    const float length = sqrt(dot3(n, n));
    const float sign = copysign(1.0f / length, dot3(n, surface.geometric));
    surface.normal = where(length > 0.0f, scaled(n, sign), surface.geometric);
    return surface;
}

FUNCTION float smooth_triangle_emission_factor(ShadingRecord record, vec3 from, vec3 p) { return 1.0f; }

FUNCTION Pattern smooth_triangle_pattern(Scene scene, ShadingRecord record, Ray ray, Hit hit) { return triangle_pattern(scene, record, ray, hit); }
