// Volumes other than boxes: whether the line that a ray is on meets one.
//
// The line of every hit comes within the pad (lane_ray.cl) of the primitive's hull, and so of a volume round it: Shape::hull() gives the box where
// less would not do. Each test is wider by a multiple of the pad, for that and for its own rounding: all its terms are at most the ray's origin and
// the scene's extent, of which the pad is 2^-20. What overflows is met.
#pragma once
#include "kernels/accelerators/bounding_volumes.h"
#include "kernels/core/rays.cl"

/// The part of a line [near, far] in terms of t.
typedef struct {
    float near, far;
} Stretch;

/// Where the line is in a box grown by the ray's pad: as within_box() in lane_ray.cl.
FUNCTION Stretch stretch_in_box(vec3 low, vec3 high, const ray_x8 *ray) {
#define SLAB(x) \
    const float low_##x = fma(low.x, ray->inverse.x.s0, ray->shift_low.x.s0), high_##x = fma(high.x, ray->inverse.x.s0, ray->shift_high.x.s0)
    SLAB(x);
    SLAB(y);
    SLAB(z);
#undef SLAB
    const Stretch stretch = {maximum(minimum(low_x, high_x), maximum(minimum(low_y, high_y), minimum(low_z, high_z))),
                             minimum(maximum(low_x, high_x), minimum(maximum(low_y, high_y), maximum(low_z, high_z)))};
    return stretch;
}

/// One ray as the volumes' tests need it.
typedef struct {
    vec3 origin, direction;
    float inverse_square, pad;
    float still;  ///< stands for a rate of 0 along the line: 2^-60 of the direction moves it by no rounding error
} Line;

FUNCTION Line line_of(const ray_x8 *ray) {
    Line line;
    line.origin = make3(ray->origin.x.s0, ray->origin.y.s0, ray->origin.z.s0);
    line.direction = make3(ray->direction.x.s0, ray->direction.y.s0, ray->direction.z.s0);
    line.inverse_square = ray->inverse_square.s0, line.pad = ray->pad.s0;
    line.still = 0x1p-60f * largest(absolute(line.direction));
    return line;
}

FUNCTION vec3 volume_vector(const global float *words) { return make3(words[0], words[1], words[2]); }

/// Squared distance of the line along d from the end of f, which leads there from a point on it.
FUNCTION float squared_distance(vec3 f, vec3 d, float inverse_square) {
    const vec3 across = minus(f, scaled(d, dot3(f, d) * inverse_square));
    return dot3(across, across);
}

FUNCTION bool meets_sphere(const global float *words, Line line) {
    const float radius = words[3] + 4.0f * line.pad;
    return !(squared_distance(minus(volume_vector(words), line.origin), line.direction, line.inverse_square) > radius * radius);
}

FUNCTION bool meets_ellipsoid(const global float *words, Line line) {
    const vec3 f = minus(volume_vector(words), line.origin), x = volume_vector(words + 3), y = volume_vector(words + 6), z = volume_vector(words + 9);
    const vec3 in_sphere = make3(dot3(x, f), dot3(y, f), dot3(z, f));
    const vec3 d = make3(dot3(x, line.direction), dot3(y, line.direction), dot3(z, line.direction));
    const float radius = 1.0f + 8.0f * line.pad * words[12];
    return !(squared_distance(in_sphere, d, 1.0f / dot3(d, d)) > radius * radius);
}

/// What of a stretch is between two planes: where p·n is from `low` to `high`, the line being at `at` + t `rate`; `still` is Line's.
FUNCTION Stretch between(Stretch stretch, float low, float high, float at, float rate, float still) {
    const float inverse = 1.0f / (fabs(rate) < still ? copysign(still, rate) : rate);
    const float a = (low - at) * inverse, b = (high - at) * inverse;
    stretch.near = maximum(stretch.near, minimum(a, b)), stretch.far = minimum(stretch.far, maximum(a, b));
    return stretch;
}

FUNCTION bool meets_oriented_box(const global float *words, Line line, Stretch stretch) {
    const vec3 f = minus(line.origin, volume_vector(words));
    for (uint axis = 0u; axis < 3u; ++axis) {
        const vec3 n = volume_vector(words + 3u + 3u * axis);
        const float half_extent = words[12u + axis] + 8.0f * line.pad;
        stretch = between(stretch, -half_extent, half_extent, dot3(f, n), dot3(line.direction, n), line.still);
    }
    return !(stretch.near > stretch.far);
}

FUNCTION bool meets_diagonals(const global float *words, Line line, Stretch stretch) {
    const vec3 o = line.origin, d = line.direction;
    const float pad = 8.0f * line.pad;
    stretch = between(stretch, words[0] - pad, words[1] + pad, o.x + o.y + o.z, d.x + d.y + d.z, line.still);
    stretch = between(stretch, words[2] - pad, words[3] + pad, o.x + o.y - o.z, d.x + d.y - d.z, line.still);
    stretch = between(stretch, words[4] - pad, words[5] + pad, o.x - o.y + o.z, d.x - d.y + d.z, line.still);
    stretch = between(stretch, words[6] - pad, words[7] + pad, o.y + o.z - o.x, d.y + d.z - d.x, line.still);
    return !(stretch.near > stretch.far);
}

/// `stretch`: where the line is in the volume's box.
FUNCTION bool meets_volume(uint kind, const global Volume *volume, Line line, Stretch stretch) {
    const global float *words = volume->words;
    switch (kind) {
        case VOLUME_SPHERE:
            return meets_sphere(words, line);
        case VOLUME_ELLIPSOID:
            return meets_ellipsoid(words, line);
        case VOLUME_ORIENTED_BOX:
            return meets_oriented_box(words, line, stretch);
        case VOLUME_DIAGONALS:
            return meets_diagonals(words, line, stretch);
        default:
            return true;
    }
}
