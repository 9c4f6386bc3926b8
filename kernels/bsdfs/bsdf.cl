// BSDFs of all kinds in use: every kind is evaluated and one selected (DESIGN: flat code).
#pragma once
#include "generated/bsdfs.cl"
#include "kernels/bsdfs/bsdf.h"
#include "kernels/core/items.cl"
#include "kernels/core/scene.h"

FUNCTION Split where(int c, Split a, Split b) {
    Split r;
    r.reflected = where(c, a.reflected, b.reflected), r.refracted = where(c, a.refracted, b.refracted);
    return r;
}

FUNCTION Spectrum bsdf_ambient(const global Material *m) {
    Spectrum result = make3(0.0f, 0.0f, 0.0f);
#define CASE(KIND, View, name) ONLY_IF(m->kind == KIND) result = where(m->kind == KIND, name##_ambient(m), result);
    FOR_EACH_BSDF(CASE)
#undef CASE
    return result;
}

/// Radiance towards `wo` per irradiance-free light from `wi` [1/sr], its cosine included; all unit vectors, away from the surface.
FUNCTION Spectrum bsdf_local(const global Material *m, vec3 normal, vec3 wo, vec3 wi) {
    Spectrum result = make3(0.0f, 0.0f, 0.0f);
#define CASE(KIND, View, name) ONLY_IF(m->kind == KIND) result = where(m->kind == KIND, name##_local(m, normal, wo, wi), result);
    FOR_EACH_BSDF(CASE)
#undef CASE
    return result;
}

FUNCTION Split bsdf_split(const global Material *m, float cosine, float cosine_squared_beyond, float eta) {
    Split result = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}};
#define CASE(KIND, View, name) \
    ONLY_IF(m->kind == KIND) result = where(m->kind == KIND, name##_split(m, cosine, cosine_squared_beyond, eta), result);
    FOR_EACH_BSDF(CASE)
#undef CASE
    return result;
}
