// What Whitted's integrator asks of the kinds in use that it can show: every kind is evaluated and one selected, since a switch would keep loops over
// items from vectorising.
#pragma once
#include "generated/whitted_bsdfs.cl"
#include "kernels/bsdfs/bsdf.h"
#include "generated/constants.h"
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/math.cl"
#include "kernels/core/scene.h"

FUNCTION Split where(int c, Split a, Split b) {
    Split r;
    r.reflected = where(c, a.reflected, b.reflected), r.refracted = where(c, a.refracted, b.refracted);
    return r;
}

FUNCTION Spectrum bsdf_ambient(const global Material *m) {
    Spectrum result = make3(0.0f, 0.0f, 0.0f);
#define CASE(KIND, View, name) \
    ONLY_IF(m->kind == KIND) result = where(m->kind == KIND, name##_ambient(m), result);
    FOR_EACH_WHITTED_BSDF(CASE)
#undef CASE
    return result;
}

FUNCTION Phong where(int c, Phong a, Phong b) {
    Phong r;
    r.diffuse = where(c, a.diffuse, b.diffuse), r.specular = where(c, a.specular, b.specular), r.exponent = where(c, a.exponent, b.exponent);
    return r;
}

FUNCTION Phong bsdf_phong(const global Material *m) {
    Phong result = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, 1.0f};
#define CASE(KIND, View, name) \
    ONLY_IF(m->kind == KIND) result = where(m->kind == KIND, name##_phong(m), result);
    FOR_EACH_WHITTED_BSDF(CASE)
#undef CASE
    return result;
}

/// (kd N·L + ks (V·R)^n) / π [1/sr] of light from `wi` towards `wo`: with diffuse reflectance ρ, a surface under irradiance E has radiance ρE/π.
FUNCTION Spectrum phong_local(Phong phong, vec3 normal, vec3 wo, vec3 wi) {
    const float cosine = dot3(normal, wi);
    Spectrum value = scaled(phong.diffuse, cosine);
    if (HIGHLIGHTS) {
        const float mirrored = maximum(2.0f * cosine * dot3(normal, wo) - dot3(wi, wo), 0.0f);
        value = plus(value, scaled(phong.specular, power(minimum(mirrored, 1.0f), phong.exponent)));
    }
    return where(cosine > 0.0f, scaled(value, INVERSE_PI), make3(0.0f, 0.0f, 0.0f));
}

/// At an interface met at `cosine`; `total`: the material transmits, but there is total internal reflection.
FUNCTION Split bsdf_split(const global Material *m, float cosine, float cosine_squared_beyond, float eta, bool total) {
    Split result = {{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}};
#define CASE(KIND, View, name) \
    ONLY_IF(m->kind == KIND) result = where(m->kind == KIND, name##_split(m, cosine, cosine_squared_beyond, eta, total), result);
    FOR_EACH_WHITTED_BSDF(CASE)
#undef CASE
    return result;
}
