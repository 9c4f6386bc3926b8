// Transforms at a time.
#pragma once
#include "kernels/core/lanes_1.cl"
#include "kernels/primitives/load_transform.cl"
#include "kernels/primitives/motion.h"

/// A time within a motion.
typedef struct {
    const global MotionPart *part;
    float s;  ///< from 0 to 1
} MotionPlace;

/// In the last of the parts that has begun by then, or else the first.
FUNCTION MotionPlace place_in_motion(const global MotionPart *parts, uint count, float time) {
    uint first = 0u;
    for (uint end = count; end - first > 1u;) {
        const uint middle = (first + end) / 2u;
        if (parts[middle].begin <= time)
            first = middle;
        else
            end = middle;
    }
    MotionPlace place;
    place.part = parts + first;
    place.s = minimum(maximum((time - place.part->begin) * place.part->rate, 0.0f), 1.0f);
    return place;
}

FUNCTION vec3 polynomial(vec3 a, vec3 b, vec3 c, vec3 d, float s) {
    return make3(fma(fma(fma(d.x, s, c.x), s, b.x), s, a.x), fma(fma(fma(d.y, s, c.y), s, b.y), s, a.y), fma(fma(fma(d.z, s, c.z), s, b.z), s, a.z));
}

FUNCTION Transform transform_at(const global Transform *terms, float s) {
    const Transform a = load(terms), b = load(terms + 1), c = load(terms + 2), d = load(terms + 3);
    Transform m;
    m.x = polynomial(a.x, b.x, c.x, d.x, s), m.y = polynomial(a.y, b.y, c.y, d.y, s), m.z = polynomial(a.z, b.z, c.z, d.z, s);
    m.origin = polynomial(a.origin, b.origin, c.origin, d.origin, s);
    return m;
}
