// How surfaces scatter light, for paths: every kind in use is evaluated and one selected.
#pragma once
#include "generated/bsdfs.cl"
#include "generated/constants.h"
#include "kernels/bsdfs/bsdf.h"
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/scene.h"

/// Whether a material that a ray has met is of this kind; where there is but one, that needs no look.
FUNCTION bool is_of_kind(const global Material *m, uint kind) { return ONE_BSDF || m->kind == kind; }

FUNCTION BsdfValue where(int c, BsdfValue a, BsdfValue b) {
    BsdfValue r;
    r.value = where(c, a.value, b.value), r.pdf = c ? a.pdf : b.pdf;
    return r;
}

FUNCTION BsdfSample where(int c, BsdfSample a, BsdfSample b) {
    BsdfSample r;
    r.wi = where(c, a.wi, b.wi), r.weight = where(c, a.weight, b.weight), r.pdf = c ? a.pdf : b.pdf;
    return r;
}

FUNCTION BsdfValue bsdf_eval(const global Material *m, BsdfPoint point, vec3 wi) {
    BsdfValue result = {{0.0f, 0.0f, 0.0f}, 0.0f};
#define CASE(KIND, View, name) \
    ONLY_IF(is_of_kind(m, KIND)) result = where(is_of_kind(m, KIND), name##_eval(m, point, wi), result);
    FOR_EACH_BSDF(CASE)
#undef CASE
    return result;
}

/// About the part of light that is reflected or let through.
FUNCTION Spectrum bsdf_albedo(const global Material *m, Tints tint) {
    Spectrum result = make3(0.0f, 0.0f, 0.0f);
#define CASE(KIND, View, name) \
    ONLY_IF(is_of_kind(m, KIND)) result = where(is_of_kind(m, KIND), name##_albedo(m, tint), result);
    FOR_EACH_BSDF(CASE)
#undef CASE
    return result;
}

/// `u` chooses the direction within a lobe, `choice` the lobe, all in [0, 1).
FUNCTION BsdfSample bsdf_sample(const global Material *m, BsdfPoint point, vec2 u, float choice) {
    BsdfSample result = {{0.0f, 0.0f, 1.0f}, {0.0f, 0.0f, 0.0f}, 0.0f};
#define CASE(KIND, View, name) \
    ONLY_IF(is_of_kind(m, KIND)) result = where(is_of_kind(m, KIND), name##_sample(m, point, u, choice), result);
    FOR_EACH_BSDF(CASE)
#undef CASE
    return result;
}
