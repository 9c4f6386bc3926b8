// A thin sheet: both of its faces, and all that goes to and fro between them, as one surface.
#pragma once
#include "kernels/bsdfs/bsdf.h"
#include "kernels/bsdfs/thin_dielectric.h"
#include "kernels/core/load.cl"
#include "kernels/core/refraction.cl"
#include "kernels/core/scene.h"

FUNCTION ThinDielectric thin_dielectric_view(const global Material *m) {
    ThinDielectric t;
    t.reflection = load_floats(m->words), t.transmission = load_floats(m->words + 3);
    return t;
}

/// Where each face mirrors F, of the light R = F + (1 - F)² F + (1 - F)² F³ + ... = 2 F / (1 + F) comes back and the rest passes. Seen from the
/// sheet's faces inside, F is the same; there is none where light, from a denser medium around the sheet, does not enter it.
FUNCTION float sheet_reflectance(float cosine, float eta) {
    const float f = eta == 1.0f ? 0.0f : fresnel(cosine, refracted_cosine_squared(cosine, eta), eta);
    return 2.0f * f / (1.0f + f);
}

/// Both lobes are single directions.
FUNCTION BsdfValue thin_dielectric_eval(const global Material *m, BsdfPoint point, vec3 wi) {
    const BsdfValue nothing = {{0.0f, 0.0f, 0.0f}, 0.0f};
    return nothing;
}

/// Light that passes keeps its direction, and its medium: no factor of radiance.
FUNCTION BsdfSample thin_dielectric_sample(const global Material *m, BsdfPoint point, vec2 u, float choice) {
    const ThinDielectric sheet = thin_dielectric_view(m);
    const bool reflects = choice < sheet_reflectance(point.wo.z, point.eta);
    BsdfSample sample;
    sample.wi = make3(-point.wo.x, -point.wo.y, where(reflects, point.wo.z, -point.wo.z));
    sample.weight = where(reflects, sheet.reflection, sheet.transmission);
    sample.pdf = INFINITY;
    return sample;
}

FUNCTION Spectrum thin_dielectric_albedo(const global Material *m, Tints tint) {
    const ThinDielectric view = thin_dielectric_view(m);
    return maximum(view.reflection, view.transmission);
}
