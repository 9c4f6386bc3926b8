// Template: rays, boxes and crossings for the lane width in force: LaneRay, LaneBox and Crossing name that width's types. Included once per width.
#include "generated/time.cl"
#include "generated/work.cl"

/// Ray(s) prepared for tracing. Boxes are tested as (plane ∓ pad - origin) / direction, where the pad exceeds every rounding error of the
/// primitives' tests; the same formula for every box makes the test monotone: whoever hits a box hits all boxes around it.
typedef struct {
    real3 origin, direction;
    real t_max;
    real inverse_square;                   ///< 1 / direction²
    mask source;                           ///< number of the primitive that it leaves
    mask source_instance;                  ///< and the instance which that is in; only in scenes with instances, and in the world
    real pad;                              ///< by which boxes are grown: more than any rounding error of a crossing
    real3 inverse, shift_low, shift_high;  ///< plane of a box -> t: fma(plane, inverse, shift)
    real3 turned_origin;                   ///< origin[kx], origin[ky], origin[kz]
    real3 shear;                           ///< direction[kx] / direction[kz], direction[ky] / direction[kz], 1 / direction[kz]
    uint kx, ky, kz;                       ///< axes; kz has the largest component of the direction
    TIME_OF_RAY
    WORK_OF_RAY
} LaneRay;

/// Around a primitive, without the pad.
typedef struct {
    real3 low, high;
} LaneBox;

/// Where a ray meets a primitive.
typedef struct {
    real t, u, v;
    mask hit;
} Crossing;

FUNCTION real axis_of(real3 v, uint axis) { return axis == 0u ? v.x : axis == 1u ? v.y : v.z; }

/// By which boxes are grown: more than any rounding error of a crossing. `extent`: largest magnitude of a coordinate in the scene.
FUNCTION real box_pad(real3 origin, float extent) { return 0x1p-20f * (largest(absolute(origin)) + extent); }

/// Of a direction turned so that z is an axis of its largest component.
FUNCTION real3 shear_of(real3 turned) { return make3(turned.x / turned.z, turned.y / turned.z, 1.0f / turned.z); }

FUNCTION mask are_finite(real3 v) { return fma(v.x, 0.0f, fma(v.y, 0.0f, v.z * 0.0f)) == 0.0f; }

/// kz must be an axis of the largest component of every direction. Rays with anything but finite numbers meet nothing: they end before they begin,
/// because comparisons with what comes of them would let them into every box.
FUNCTION LaneRay lane_ray(real3 origin, real3 direction, real t_max, uint kz, mask source, float extent) {
    LaneRay ray;
    ray.inverse_square = 1.0f / dot3(direction, direction);
    ray.origin = origin, ray.direction = direction, ray.source = source;
    ray.pad = box_pad(origin, extent);
    // A component of 0 would give 0 · ∞; 2^-60 of the largest one moves no ray by a rounding error.
    const real tiny = 0x1p-60f * largest(absolute(direction));
    const real3 d = make3(where(fabs(direction.x) < tiny, copysign(tiny, direction.x), direction.x),
                          where(fabs(direction.y) < tiny, copysign(tiny, direction.y), direction.y),
                          where(fabs(direction.z) < tiny, copysign(tiny, direction.z), direction.z));
    ray.inverse = make3(1.0f / d.x, 1.0f / d.y, 1.0f / d.z);
    ray.t_max = where(are_finite(origin) & are_finite(direction) & are_finite(ray.inverse), t_max, -1.0f);
    const real3 pads = make3(ray.pad, ray.pad, ray.pad);
    ray.shift_low = negate(times(plus(origin, pads), ray.inverse));
    ray.shift_high = negate(times(minus(origin, pads), ray.inverse));
    ray.kz = kz, ray.kx = kz == 2u ? 0u : kz + 1u, ray.ky = kz == 0u ? 2u : kz - 1u;
    ray.turned_origin = make3(axis_of(origin, ray.kx), axis_of(origin, ray.ky), axis_of(origin, ray.kz));
    ray.shear = shear_of(make3(axis_of(direction, ray.kx), axis_of(direction, ray.ky), axis_of(direction, ray.kz)));
    return ray;
}

/// A crossing counts only within its primitive's own box, where it is moved if rounding took it before the box, and not if the box lies behind the
/// ray. So no box around can lose it, or be the only one to keep it.
FUNCTION Crossing within_box(Crossing crossing, LaneBox box, LaneRay ray) {
    const real3 low = box.low, high = box.high;
    const real3 a =
        make3(fma(low.x, ray.inverse.x, ray.shift_low.x), fma(low.y, ray.inverse.y, ray.shift_low.y), fma(low.z, ray.inverse.z, ray.shift_low.z));
    const real3 b = make3(fma(high.x, ray.inverse.x, ray.shift_high.x), fma(high.y, ray.inverse.y, ray.shift_high.y),
                          fma(high.z, ray.inverse.z, ray.shift_high.z));
    const real near = largest(minimum(a, b));
    const real3 far = maximum(a, b);
    crossing.t = maximum(crossing.t, near);
    crossing.hit &= (maximum(near, 0.0f) <= minimum(far.x, minimum(far.y, far.z))) & (crossing.t <= ray.t_max);
    return crossing;
}
