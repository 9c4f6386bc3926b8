// Whitted's surface (Whitted, CACM 23(6) 1980).
#pragma once
#include "kernels/bsdfs/bsdf.h"
#include "kernels/bsdfs/whitted.h"
#include "kernels/core/load.cl"
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

/// Fresnel's law divides them, and neither is lost.
FUNCTION Spectrum whitted_secondary(const global Material *m) {
    const Whitted w = whitted_view(m);
    return where(w.fresnel != 0u, maximum(w.reflection, w.transmission), plus(w.reflection, w.transmission));
}

FUNCTION Phong whitted_phong(const global Material *m) {
    const Whitted w = whitted_view(m);
    Phong phong;
    phong.diffuse = w.diffuse, phong.specular = w.specular, phong.exponent = w.exponent;
    return phong;
}

/// At total internal reflection the reflected ray carries both weights, or with Fresnel's law its own.
FUNCTION Split whitted_split(const global Material *m, float cosine, float cosine_squared_beyond, float eta, bool total) {
    const Whitted w = whitted_view(m);
    const float f = fresnel(cosine, cosine_squared_beyond, eta);
    const Spectrum black = make3(0.0f, 0.0f, 0.0f);
    Split split;
    split.reflected = where(w.fresnel != 0u, scaled(w.reflection, f), plus(w.reflection, where(total, w.transmission, black)));
    split.refracted = where(total, black, where(w.fresnel != 0u, scaled(w.transmission, 1.0f - f), w.transmission));
    return split;
}
