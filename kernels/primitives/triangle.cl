// Triangle: the surface at a hit.
#pragma once
#include "kernels/core/load.cl"
#include "kernels/core/items.h"
#include "kernels/core/scene.cl"
#include "kernels/primitives/surface.h"
#include "kernels/primitives/triangle.h"

FUNCTION TriangleShading triangle_view(const global ShadingRecord *record) {
    TriangleShading triangle;
    triangle.a = load_floats(record->words);
    triangle.b = load_floats(record->words + 3);
    triangle.c = load_floats(record->words + 6);
    return triangle;
}

FUNCTION vec3 cross_of_differences(vec3 a, vec3 b, vec3 c) {
    const vec3 e = minus(b, a), f = minus(c, a);
    return make3(difference_of_products(e.y, f.z, e.z, f.y), difference_of_products(e.z, f.x, e.x, f.z), difference_of_products(e.x, f.y, e.y, f.x));
}

/// The point as a weighted mean of the vertices: its error does not grow with the ray's length (Pharr et al., PBR 4ed, 6.8.5).
FUNCTION Surface triangle_surface(Scene scene, const global ShadingRecord *record, Ray ray, Hit hit) {
    const TriangleShading triangle = triangle_view(record);
    const vec3 a = scaled(triangle.a, 1.0f - hit.u - hit.v), b = scaled(triangle.b, hit.u), c = scaled(triangle.c, hit.v);
    const vec3 n = cross_of_differences(triangle.a, triangle.b, triangle.c);
    Surface surface;
    surface.p = plus(a, plus(b, c));
    surface.error = scaled(plus(absolute(a), plus(absolute(b), absolute(c))), 0x1p-21f);  // at least gamma(7)
    surface.geometric = unit(scaled(n, 1.0f / largest(absolute(n))));                     // squares of small normals underflow
    surface.normal = surface.geometric;
    return surface;
}
