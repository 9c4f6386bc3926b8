// A diffuse base under a clear coat. What the boundary does not reflect enters; of what the base reflects, the part `internal` comes back to it,
// again and again. The diffuse lobe has the factor 1 - reflectance of both directions, so that a white base loses nothing.
#pragma once
#include "kernels/bsdfs/angle_curve.cl"
#include "kernels/bsdfs/bsdf.h"
#include "kernels/bsdfs/microfacet.cl"
#include "kernels/bsdfs/plastic.h"
#include "kernels/bsdfs/sample.cl"
#include "kernels/core/load.cl"
#include "kernels/core/refraction.cl"
#include "kernels/core/scene.h"

/// But for the curve, which stays in memory.
FUNCTION Plastic plastic_view(const global Material *m) {
    Plastic p;
    p.diffuse = load_floats(m->words);
    p.eta = as_float(m->words[3]), p.internal = as_float(m->words[4]), p.scale = as_float(m->words[5]), p.alpha = as_float(m->words[6]);
    p.distribution = m->words[7], p.nonlinear = m->words[8];
    return p;
}

FUNCTION Microfacets plastic_facets(Plastic p) {
    Microfacets facets;
    facets.alpha = p.alpha, facets.distribution = p.distribution;
    return facets;
}

FUNCTION float plastic_fresnel(Plastic p, float cosine) { return fresnel(cosine, refracted_cosine_squared(cosine, p.eta), p.eta); }

/// Part of light at this angle that the boundary reflects at once.
FUNCTION float plastic_coat(const global Material *m, Plastic p, float cosine) {
    return minimum(maximum(plastic_fresnel(p, cosine) * value_at(m->words + PLASTIC_COAT_WORD, p.alpha, cosine), 0.0f), 1.0f);
}

/// Reflectance of the base, seen through an ideal boundary that lets everything through at last.
FUNCTION float plastic_base(Plastic p, float reflectance) {
    const float bounded = minimum(reflectance, 1.0f);
    return p.nonlinear != 0u ? bounded * (1.0f - p.internal) / (1.0f - bounded * p.internal) : bounded;
}

FUNCTION Spectrum plastic_base(Plastic p, Spectrum tint) {
    return make3(plastic_base(p, p.diffuse.x * tint.x), plastic_base(p, p.diffuse.y * tint.y), plastic_base(p, p.diffuse.z * tint.z));
}

/// With which `sample` chooses the coat.
FUNCTION float plastic_coat_chance(float coat, Spectrum base) {
    const float below = (1.0f - coat) * (base.x + base.y + base.z) * 0.333333333f;
    return coat > 0.0f ? coat / (coat + below) : 0.0f;
}

FUNCTION BsdfValue plastic_eval(const global Material *m, BsdfPoint point, vec3 wi) {
    const Plastic p = plastic_view(m);
    const Spectrum base = plastic_base(p, point.diffuse_tint);
    const float coat = plastic_coat(m, p, point.wo.z), chance = plastic_coat_chance(coat, base);
    const float diffuse = (1.0f - coat) * (1.0f - plastic_coat(m, p, wi.z)) * p.scale * wi.z;
    const FacetReflection facet = reflected_by_facets(plastic_facets(p), point.wo, wi);
    const int rough = is_rough(p.alpha);
    const float gloss = where(rough, plastic_fresnel(p, facet.cosine) * facet.value, 0.0f);
    const float pdf = chance * where(rough, facet.pdf, 0.0f) + (1.0f - chance) * INVERSE_PI * wi.z;
    return above_surface(wi.z > 0.0f, plus(scaled(base, diffuse), scaled(point.specular_tint, gloss)), pdf);
}

FUNCTION BsdfSample plastic_sample(const global Material *m, BsdfPoint point, vec2 u, float choice) {
    const Plastic p = plastic_view(m);
    const float coat = plastic_coat(m, p, point.wo.z), chance = plastic_coat_chance(coat, plastic_base(p, point.diffuse_tint));
    const int chosen = choice < chance;
    const vec3 wi = where(chosen, mirrored_by_facet(plastic_facets(p), point.wo, u), cosine_hemisphere(u));
    const Spectrum ideal = scaled(point.specular_tint, coat / chance);
    return sample_or_mirror(chosen & !is_rough(p.alpha), ideal, point.wo, sample_towards(wi, plastic_eval(m, point, wi)));
}

FUNCTION Spectrum plastic_albedo(const global Material *m, Tints tint) {
    const Plastic p = plastic_view(m);
    const float coat = plastic_coat(m, p, 1.0f);
    return plus(scaled(plastic_base(p, tint.diffuse), 1.0f - coat), scaled(tint.specular, coat));
}
