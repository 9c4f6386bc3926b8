// Times of samples, and where a moving camera is then.
#pragma once
#include "generated/constants.h"
#include "generated/instances.cl"
#include "generated/sampler.cl"
#include "kernels/core/items.h"
#include "kernels/core/params.h"
#include "kernels/primitives/motion.cl"
#include "kernels/primitives/transform_x1.cl"
#include "kernels/samplers/uses.h"

typedef MotionPart CameraMotion;

/// Uniform while the shutter is open.
FUNCTION float time_of_sample(uint pixel, uint sample, BatchParams batch, ShutterParams shutter) {
    return fma(sampler_pair(pixel, sample, whole_sample(), USE_TIME, batch).x, shutter.close - shutter.open, shutter.open);
}

/// `ray` as the camera has it in its own space. Motions keep lengths but for rounding.
FUNCTION Ray moved_with_camera(Ray ray, const global CameraMotion *motion, ShutterParams shutter, float time) {
    if (shutter.parts == 0u) return ray;
    const MotionPlace place = place_in_motion(motion, shutter.parts, time);
    const Transform m = transform_at(place.part->to_world, place.s);
    ray.origin = transformed_point(m, ray.origin), ray.direction = unit(transformed_direction(m, ray.direction));
    return ray;
}

/// A ray from the eye leaves no primitive, and so none of an instance.
FUNCTION void store_time(global uint *sources, uint i, float time) {
    if (INSTANCES_MOVE) store_instance(sources, i, PLACEMENT(0u, time));
}
