// What samples of all kinds have in common.
#pragma once
#include "kernels/bsdfs/bsdf.h"
#include "kernels/core/lanes_1.cl"

/// A reflectance that a picture multiplies, which may brighten it, but not beyond what arrives.
FUNCTION Spectrum tinted(Spectrum reflectance, Spectrum tint) { return minimum(times(reflectance, tint), make3(1.0f, 1.0f, 1.0f)); }

/// Nothing arrives from below the surface.
FUNCTION BsdfValue above_surface(int is_seen, Spectrum value, float pdf) {
    BsdfValue result;
    result.value = where(is_seen, value, make3(0.0f, 0.0f, 0.0f)), result.pdf = where(is_seen, pdf, 0.0f);
    return result;
}

/// A direction that has been chosen, with what `eval` says of it.
FUNCTION BsdfSample sample_towards(vec3 wi, BsdfValue at) {
    BsdfSample sample;
    sample.wi = wi, sample.pdf = at.pdf;
    sample.weight = where(at.pdf > 0.0f, scaled(at.value, 1.0f / at.pdf), make3(0.0f, 0.0f, 0.0f));
    return sample;
}

/// The same, or with `is_ideal` the mirrored direction, a lobe of that alone.
FUNCTION BsdfSample sample_or_mirror(int is_ideal, Spectrum mirrored_weight, vec3 wo, BsdfSample other) {
    BsdfSample sample;
    sample.wi = where(is_ideal, make3(-wo.x, -wo.y, wo.z), other.wi);
    sample.weight = where(is_ideal, mirrored_weight, other.weight), sample.pdf = where(is_ideal, INFINITY, other.pdf);
    return sample;
}
