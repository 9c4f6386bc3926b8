// Triangle: the surface at a hit.
#pragma once
#include "kernels/core/load.cl"
#include "kernels/core/items.h"
#include "kernels/core/scene.cl"
#include "kernels/primitives/surface.h"
#include "kernels/primitives/triangle.h"

#define TRIANGLE(name) triangle_surface_##name
#include "kernels/primitives/triangle_plane.cl"
#undef TRIANGLE

FUNCTION TriangleShading triangle_view(ShadingRecord record) {
    TriangleShading triangle;
    triangle.a = load_floats(record.words);
    triangle.b = load_floats(record.words + 3);
    triangle.c = load_floats(record.words + 6);
    return triangle;
}

/// The point as a weighted mean of the vertices, whose error does not grow with the ray's length (Pharr et al., PBR 4ed, 6.8.5), is put onto the
/// plane with twice the digits: what is left is its own rounding, however large the triangle is.
FUNCTION Surface triangle_surface(Scene scene, ShadingRecord record, Ray ray, Hit hit) {
    const TriangleShading triangle = triangle_view(record);
    const vec3 a = scaled(triangle.a, 1.0f - hit.u - hit.v), b = scaled(triangle.b, hit.u), c = scaled(triangle.c, hit.v);
    const vec3 mean = plus(a, plus(b, c));
    vec3 n;
    const float offset = triangle_surface_plane_offset(triangle.a, triangle.b, triangle.c, mean, &n);
    const vec3 n1 = scaled(n, 1.0f / largest(absolute(n)));  // squares of small normals underflow
    Surface surface;
    surface.geometric = unit(n1);
    surface.p = minus(mean, scaled(n1, offset / dot3(n, n1)));
    // The difference's own rounding; and of the mean's error, 2^-21 of its terms, the correction leaves 2^-21, the offset's rounding less.
    surface.error = plus(scaled(absolute(surface.p), 0x1p-22f), scaled(plus(absolute(a), plus(absolute(b), absolute(c))), 0x1p-38f));
    surface.normal = surface.geometric;
    surface.lift = make3(0.0f, 0.0f, 0.0f);
    return surface;
}

/// Points of it as a light are uniform by area.
FUNCTION float triangle_emission_factor(ShadingRecord record, vec3 from, vec3 p) { return 1.0f; }

/// Both are interpolated between the vertices.
FUNCTION Pattern triangle_pattern(Scene scene, ShadingRecord record, Ray ray, Hit hit) {
    const uint uvs = record.words[9], colors = record.words[10];
    const float w = 1.0f - hit.u - hit.v;
    Pattern pattern = {{0.0f, 0.0f}, {1.0f, 1.0f, 1.0f}};
    if (uvs != 0u) {
        const VertexUvs at = SCENE_ARRAY(scene, VertexUvs, vertex_uvs)[uvs - 1u];
        pattern.uv.x = at.a.x * w + at.b.x * hit.u + at.c.x * hit.v;
        pattern.uv.y = at.a.y * w + at.b.y * hit.u + at.c.y * hit.v;
    }
    if (colors != 0u) {
        const VertexColors at = SCENE_ARRAY(scene, VertexColors, vertex_colors)[colors - 1u];
        pattern.color = plus(scaled(at.a, maximum(w, 0.0f)), plus(scaled(at.b, hit.u), scaled(at.c, hit.v)));
    }
    return pattern;
}
