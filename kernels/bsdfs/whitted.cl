// Whitted's surface (Whitted, CACM 23(6) 1980).
#pragma once
#include "kernels/bsdfs/bsdf.h"
#include "kernels/bsdfs/sample.cl"
#include "kernels/bsdfs/whitted.h"
#include "kernels/core/frame.cl"
#include "kernels/core/load.cl"
#include "kernels/core/math.cl"
#include "kernels/core/refraction.cl"
#include "kernels/core/scene.h"
#include "kernels/core/warp.cl"

FUNCTION Whitted whitted_view(const global Material *m) {
    Whitted w;
    w.ambient = load_floats(m->words), w.diffuse = load_floats(m->words + 3), w.specular = load_floats(m->words + 6);
    w.reflection = load_floats(m->words + 9), w.transmission = load_floats(m->words + 12);
    w.exponent = as_float(m->words[15]), w.fresnel = m->words[16];
    return w;
}

/// Reflectance of ambient light.
FUNCTION Spectrum whitted_ambient(const global Material *m) { return whitted_view(m).ambient; }

/// The highlight is the lights' image and no part of it. Fresnel's law divides the secondary rays, and neither is lost.
FUNCTION Spectrum whitted_albedo(const global Material *m, Tints tint) {
    const Whitted w = whitted_view(m);
    const Spectrum secondary = where(w.fresnel != 0u, maximum(w.reflection, w.transmission), plus(w.reflection, w.transmission));
    return plus(times(w.diffuse, tint.diffuse), secondary);
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

/// Lobes of a Whitted surface as a BSDF, and how likely each is followed.
typedef struct {
    Phong phong;
    Split split;
    float cosine_squared_beyond;
    float diffuse, specular, reflected, refracted;  ///< chances, of sum 1 or, where the surface is black, 0
} WhittedLobes;

FUNCTION WhittedLobes whitted_lobes(const global Material *m, BsdfPoint point) {
    WhittedLobes lobes;
    lobes.phong = whitted_phong(m);
    lobes.phong.diffuse = times(lobes.phong.diffuse, point.diffuse_tint), lobes.phong.specular = times(lobes.phong.specular, point.specular_tint);
    lobes.cosine_squared_beyond = refracted_cosine_squared(point.wo.z, point.eta);
    const bool total = ((m->flags & MATERIAL_TRANSMITS) != 0u) & (lobes.cosine_squared_beyond < 0.0f);
    lobes.split = whitted_split(m, point.wo.z, lobes.cosine_squared_beyond, point.eta, total);
    const float diffuse = largest(lobes.phong.diffuse), specular = largest(lobes.phong.specular) * 2.0f / (lobes.phong.exponent + 1.0f);
    const float reflected = largest(lobes.split.reflected), refracted = largest(lobes.split.refracted);
    const float sum = diffuse + specular + reflected + refracted, share = sum > 0.0f ? 1.0f / sum : 0.0f;
    lobes.diffuse = diffuse * share, lobes.specular = specular * share, lobes.reflected = reflected * share, lobes.refracted = refracted * share;
    return lobes;
}

FUNCTION BsdfValue whitted_eval_lobes(WhittedLobes lobes, vec3 wo, vec3 wi) {
    const float mirrored = minimum(maximum(wo.z * wi.z - wo.x * wi.x - wo.y * wi.y, 0.0f), 1.0f), highlight = power(mirrored, lobes.phong.exponent);
    const Spectrum value = plus(scaled(lobes.phong.diffuse, wi.z), scaled(lobes.phong.specular, highlight));
    const float pdf = lobes.diffuse * wi.z + lobes.specular * 0.5f * (lobes.phong.exponent + 1.0f) * highlight;
    return above_surface(wi.z > 0.0f, scaled(value, INVERSE_PI), pdf * INVERSE_PI);
}

/// kd/π cos θi + ks/π cos^n α: what phong_local gives as radiance of unit irradiance.
FUNCTION BsdfValue whitted_eval(const global Material *m, BsdfPoint point, vec3 wi) {
    return whitted_eval_lobes(whitted_lobes(m, point), point.wo, wi);
}

/// The highlight's density is (n + 1) / 2π cos^n α around the mirrored direction; what lies below the surface is lost.
FUNCTION BsdfSample whitted_sample(const global Material *m, BsdfPoint point, vec2 u, float choice) {
    const WhittedLobes lobes = whitted_lobes(m, point);
    const vec3 wo = point.wo, mirror = make3(-wo.x, -wo.y, wo.z);
    const vec3 specular = from_axis(mirror, power_cosine(u.x, lobes.phong.exponent), turn(u.y));
    const bool is_rough = choice < lobes.diffuse + lobes.specular;
    const bool mirrors = (choice < lobes.diffuse + lobes.specular + lobes.reflected) | !(lobes.refracted > 0.0f);
    const vec3 rough = where(choice < lobes.diffuse, cosine_hemisphere(u), specular);
    const vec3 bent = refracted(wo, make3(0.0f, 0.0f, 1.0f), wo.z, lobes.cosine_squared_beyond, point.eta);
    const float chance = mirrors ? lobes.reflected : lobes.refracted, inverse = chance > 0.0f ? 1.0f / chance : 0.0f;
    const Spectrum smooth = where(mirrors, lobes.split.reflected, scaled(lobes.split.refracted, point.eta * point.eta));
    BsdfSample sample = sample_towards(rough, whitted_eval_lobes(lobes, wo, rough));
    sample.wi = where(is_rough, rough, where(mirrors, mirror, bent));
    sample.weight = where(is_rough, sample.weight, scaled(smooth, inverse));
    sample.pdf = is_rough ? sample.pdf : INFINITY;
    return sample;
}
