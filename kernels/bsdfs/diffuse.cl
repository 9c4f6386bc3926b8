// Lambert's surface.
#pragma once
#include "kernels/bsdfs/bsdf.h"
#include "kernels/bsdfs/diffuse.h"
#include "kernels/bsdfs/sample.cl"
#include "kernels/core/load.cl"
#include "kernels/core/scene.h"
#include "kernels/core/warp.cl"

FUNCTION BsdfValue diffuse_eval(const global Material *m, BsdfPoint point, vec3 wi) {
    const float pdf = wi.z * INVERSE_PI;
    return above_surface(wi.z > 0.0f, scaled(tinted(load_floats(m->words), point.diffuse_tint), pdf), pdf);
}

FUNCTION BsdfSample diffuse_sample(const global Material *m, BsdfPoint point, vec2 u, float choice) {
    const vec3 wi = cosine_hemisphere(u);
    return sample_towards(wi, diffuse_eval(m, point, wi));
}

FUNCTION Spectrum diffuse_albedo(const global Material *m, Tints tint) { return tinted(load_floats(m->words), tint.diffuse); }
