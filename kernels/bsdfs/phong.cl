// Phong's model with reciprocity and bounded energy (Lafortune & Willems, report CW 197, KU Leuven 1994).
#pragma once
#include "kernels/bsdfs/bsdf.h"
#include "kernels/bsdfs/phong.h"
#include "kernels/bsdfs/sample.cl"
#include "kernels/core/frame.cl"
#include "kernels/core/load.cl"
#include "kernels/core/scene.h"
#include "kernels/core/warp.cl"

/// Pictures may brighten both reflectances, which are scaled to a sum of 1 where that is larger.
FUNCTION ModifiedPhong phong_view(const global Material *m, Spectrum diffuse_tint, Spectrum specular_tint) {
    const Spectrum diffuse = times(load_floats(m->words), diffuse_tint), specular = times(load_floats(m->words + 3), specular_tint);
    const float bound = 1.0f / maximum(largest(plus(diffuse, specular)), 1.0f);
    ModifiedPhong p;
    p.diffuse = scaled(diffuse, bound), p.specular = scaled(specular, bound);
    p.exponent = as_float(m->words[6]);
    return p;
}

/// With which `sample` chooses the highlight.
FUNCTION float phong_specular_chance(ModifiedPhong p) {
    const float specular = p.specular.x + p.specular.y + p.specular.z, all = specular + p.diffuse.x + p.diffuse.y + p.diffuse.z;
    return all > 0.0f ? specular / all : 0.0f;
}

FUNCTION BsdfValue phong_eval(const global Material *m, BsdfPoint point, vec3 wi) {
    const ModifiedPhong p = phong_view(m, point.diffuse_tint, point.specular_tint);
    const float chance = phong_specular_chance(p), cosine = wi.z * point.wo.z - wi.x * point.wo.x - wi.y * point.wo.y;
    const float lobe = power(minimum(maximum(cosine, 0.0f), 1.0f), p.exponent) * (0.5f * INVERSE_PI), diffuse = wi.z * INVERSE_PI;
    const Spectrum value = plus(scaled(p.diffuse, diffuse), scaled(p.specular, (p.exponent + 2.0f) * lobe * wi.z));
    return above_surface(wi.z > 0.0f, value, chance * (p.exponent + 1.0f) * lobe + (1.0f - chance) * diffuse);
}

FUNCTION BsdfSample phong_sample(const global Material *m, BsdfPoint point, vec2 u, float choice) {
    const ModifiedPhong p = phong_view(m, point.diffuse_tint, point.specular_tint);
    const vec3 axis = make3(-point.wo.x, -point.wo.y, point.wo.z);
    const vec3 lobe = from_axis(axis, power_cosine(u.x, p.exponent), turn(u.y));
    const vec3 wi = where(choice < phong_specular_chance(p), lobe, cosine_hemisphere(u));
    return sample_towards(wi, phong_eval(m, point, wi));
}

FUNCTION Spectrum phong_albedo(const global Material *m, Tints tint) {
    const ModifiedPhong p = phong_view(m, tint.diffuse, tint.specular);
    return plus(p.diffuse, p.specular);
}
