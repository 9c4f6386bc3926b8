// A surface that is not there.
#pragma once
#include "kernels/bsdfs/bsdf.h"
#include "kernels/bsdfs/null.h"
#include "kernels/core/load.cl"
#include "kernels/core/scene.h"

/// The only lobe is a single direction.
FUNCTION BsdfValue null_eval(const global Material *m, BsdfPoint point, vec3 wi) {
    const BsdfValue nothing = {{0.0f, 0.0f, 0.0f}, 0.0f};
    return nothing;
}

FUNCTION BsdfSample null_sample(const global Material *m, BsdfPoint point, vec2 u, float choice) {
    BsdfSample sample;
    sample.wi = make3(-point.wo.x, -point.wo.y, -point.wo.z);
    sample.weight = load_floats(m->words);
    sample.pdf = INFINITY;
    return sample;
}

FUNCTION Spectrum null_albedo(const global Material *m, Tints tint) { return load_floats(m->words); }
