// Smooth triangle: the surface at a hit.
#pragma once
#include "kernels/core/load.cl"
#include "kernels/primitives/smooth_triangle.h"
#include "kernels/primitives/triangle.cl"

/// By how much a vertex's tangent plane lies above p, along its normal.
FUNCTION vec3 lift_to_tangent(vec3 p, vec3 vertex, vec3 normal) { return scaled(normal, maximum(dot3(minus(vertex, p), normal), 0.0f)); }

/// The shading normal is the interpolated one, on the geometric normal's side. Between the vertices' tangent planes lies the smooth surface that the
/// normals are of (Hanika, Ray Tracing Gems II 2021, chapter 4): from there light is seen up to their horizon, which faces would cut off.
FUNCTION Surface smooth_triangle_surface(Scene scene, ShadingRecord record, Ray ray, Hit hit) {
    Surface surface = triangle_surface(scene, record, ray, hit);
    const TriangleShading triangle = triangle_view(record);
    const global VertexNormals *normals = SCENE_ARRAY(scene, VertexNormals, vertex_normals) + record.words[11];
    const vec3 na = load(&normals->a), nb = load(&normals->b), nc = load(&normals->c);
    const float w = 1.0f - hit.u - hit.v;
    const vec3 n = plus(scaled(na, w), plus(scaled(nb, hit.u), scaled(nc, hit.v)));
    const float length = sqrt(dot3(n, n));
    const float sign = copysign(1.0f / length, dot3(n, surface.geometric));
    surface.normal = where(length > 0.0f, scaled(n, sign), surface.geometric);
    const float side = copysign(1.0f, -dot3(n, surface.geometric) * dot3(surface.geometric, ray.direction));
    const vec3 a = lift_to_tangent(surface.p, triangle.a, scaled(na, side)), b = lift_to_tangent(surface.p, triangle.b, scaled(nb, side)),
               c = lift_to_tangent(surface.p, triangle.c, scaled(nc, side));
    surface.lift = plus(scaled(a, maximum(w, 0.0f)), plus(scaled(b, hit.u), scaled(c, hit.v)));
    return surface;
}

FUNCTION float smooth_triangle_emission_factor(ShadingRecord record, vec3 from, vec3 p) { return 1.0f; }

FUNCTION Pattern smooth_triangle_pattern(Scene scene, ShadingRecord record, Ray ray, Hit hit) { return triangle_pattern(scene, record, ray, hit); }
