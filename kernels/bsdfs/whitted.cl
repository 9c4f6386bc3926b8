// Whitted's surface (Whitted, CACM 23(6) 1980).
#pragma once
#include "kernels/bsdfs/bsdf.h"
#include "kernels/bsdfs/whitted.h"
#include "kernels/core/load.cl"
#include "kernels/core/math.cl"
#include "kernels/core/refraction.cl"
#include "kernels/core/scene.h"

FUNCTION Whitted whitted_view(const global Material *m) {
    Whitted w;
    w.ambient = load_floats(m->words), w.diffuse = load_floats(m->words + 3), w.specular = load_floats(m->words + 6);
    w.reflection = load_floats(m->words + 9), w.transmission = load_floats(m->words + 12);
    w.exponent = as_float(m->words[15]), w.fresnel = m->words[16];
    return w;
}

/// Reflectance of ambient light.
FUNCTION Spectrum whitted_ambient(const global Material *m) { return whitted_view(m).ambient; }

/// (kd N·L + ks (V·R)^n) / π [1/sr] of light from `wi` towards `wo`: with diffuse reflectance ρ, a surface under irradiance E has radiance ρE/π.
FUNCTION Spectrum whitted_local(const global Material *m, vec3 normal, vec3 wo, vec3 wi) {
    const Whitted w = whitted_view(m);
    const float cosine = dot3(normal, wi);
    const float mirrored = maximum(2.0f * cosine * dot3(normal, wo) - dot3(wi, wo), 0.0f);
    const float highlight = power(minimum(mirrored, 1.0f), w.exponent);
    const Spectrum value = plus(scaled(w.diffuse, cosine), scaled(w.specular, highlight));
    return where(cosine > 0.0f, scaled(value, 0.318309886f), make3(0.0f, 0.0f, 0.0f));
}

/// At total internal reflection the reflected ray carries both weights, or with Fresnel's law its own.
FUNCTION Split whitted_split(const global Material *m, float cosine, float cosine_squared_beyond, float eta) {
    const Whitted w = whitted_view(m);
    const bool transmits = (m->flags & MATERIAL_TRANSMITS) != 0u;
    const bool total = transmits & (cosine_squared_beyond < 0.0f);
    const float f = fresnel(cosine, cosine_squared_beyond, eta);
    const Spectrum black = make3(0.0f, 0.0f, 0.0f);
    Split split;
    split.reflected = where(w.fresnel != 0u, scaled(w.reflection, f), plus(w.reflection, where(total, w.transmission, black)));
    split.refracted = where(total, black, where(w.fresnel != 0u, scaled(w.transmission, 1.0f - f), w.transmission));
    return split;
}
