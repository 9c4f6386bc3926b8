// Disk: the surface at a hit.
#pragma once
#include "kernels/core/items.h"
#include "kernels/core/load.cl"
#include "kernels/core/scene.cl"
#include "kernels/primitives/azimuth.cl"
#include "kernels/primitives/disk.h"
#include "kernels/primitives/surface.h"

FUNCTION DiskShading disk_view(ShadingRecord record) {
    DiskShading disk;
    disk.center = load_floats(record.words);
    disk.normal = load_floats(record.words + 3);
    disk.radius = as_float(record.words[6]);
    return disk;
}

/// From the centre to where the ray met the disk's plane.
FUNCTION vec3 disk_place(DiskShading disk, Ray ray, Hit hit) {
    const vec3 f = plus(minus(ray.origin, disk.center), scaled(ray.direction, hit.t));
    return minus(f, scaled(disk.normal, dot3(f, disk.normal)));
}

/// Points of it as a light are uniform by area.
FUNCTION float disk_emission_factor(ShadingRecord record, vec3 from, vec3 p) { return 1.0f; }

/// The point is put back onto the plane, with twice the digits: what is left is its own rounding, however long the ray is and however large the disk.
/// It is within the rim, because the crossing has the same floats.
FUNCTION Surface disk_surface(Scene scene, ShadingRecord record, Ray ray, Hit hit) {
    const DiskShading disk = disk_view(record);
    const vec3 p = plus(disk.center, disk_place(disk, ray, hit));
    Surface surface;
    surface.p = minus(p, scaled(disk.normal, rounded(dot3(two_difference(p, disk.center), disk.normal))));
    // The difference's own rounding; and of the first point's error, 2^-21 of its terms, the correction leaves 2^-22, since that is as far as the
    // normal's square is from 1.
    const float size = largest(absolute(disk.center)) + disk.radius;
    surface.error = plus(scaled(absolute(surface.p), 0x1p-22f), scaled(make3(size, size, size), 0x1p-38f));
    surface.geometric = disk.normal;
    surface.normal = disk.normal;
    surface.lift = make3(0.0f, 0.0f, 0.0f);
    return surface;
}

/// v grows from the centre, 0, to the rim, 1; u runs around, counterclockwise as seen from where the normal leads, as on a cylinder about it.
FUNCTION Pattern disk_pattern(Scene scene, ShadingRecord record, Ray ray, Hit hit) {
    const DiskShading disk = disk_view(record);
    const vec3 x = disk_place(disk, ray, hit);
    Pattern pattern = {{0.0f, 0.0f}, {1.0f, 1.0f, 1.0f}};
    pattern.uv.x = azimuth(disk.normal, x);
    pattern.uv.y = minimum(sqrt(dot3(x, x)) / disk.radius, 1.0f);
    return pattern;
}
