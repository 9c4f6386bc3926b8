// Metal: facets that reflect by Fresnel's law, and what they reflect onto each other (Kulla & Conty, Revisiting Physically Based Shading at
// Imageworks, SIGGRAPH course 2017).
#pragma once
#include "kernels/bsdfs/angle_curve.cl"
#include "kernels/bsdfs/bsdf.h"
#include "kernels/bsdfs/conductor.h"
#include "kernels/bsdfs/microfacet.cl"
#include "kernels/bsdfs/sample.cl"
#include "kernels/bsdfs/shadowed.cl"
#include "kernels/core/load.cl"
#include "kernels/core/scene.h"

/// But for the curve, which stays in memory.
FUNCTION Conductor conductor_view(const global Material *m) {
    Conductor c;
    c.eta = load_floats(m->words), c.k = load_floats(m->words + 3), c.specular = load_floats(m->words + 6);
    c.multiple = load_floats(m->words + 9);
    c.alpha = as_float(m->words[12]), c.distribution = m->words[13];
    return c;
}

FUNCTION Microfacets conductor_facets(Conductor c) {
    Microfacets facets;
    facets.alpha = c.alpha, facets.distribution = c.distribution;
    return facets;
}

/// Part of light at this angle that facets do not reflect at once. The curve is that of its root, so that it is not negative.
FUNCTION float conductor_lost(const global Material *m, Conductor c, float z) {
    const float root = value_at(m->words + CONDUCTOR_LOST_WORD, c.alpha, z);
    return minimum(root * root, 1.0f);
}

/// Light that is reflected once, by facets whose chance is the part that is, and the rest.
FUNCTION BsdfValue conductor_eval(const global Material *m, BsdfPoint point, vec3 wi) {
    const Conductor c = conductor_view(m);
    const Microfacets facets = conductor_facets(c);
    const float again = conductor_lost(m, c, point.wo.z);
    const FacetReflection facet = reflected_by_facets(facets, point.wo, wi);
    const Spectrum single = scaled(conductor_fresnel(facet.cosine, c.eta, c.k), facet.value);
    const Spectrum value = plus(single, scaled(c.multiple, again * conductor_lost(m, c, wi.z) * wi.z));
    const float pdf = (1.0f - again) * facet.pdf + again * shadowed_density(c.alpha * c.alpha, wi.z);
    return above_surface((wi.z > 0.0f) & is_rough(c.alpha), times(value, tinted(c.specular, point.specular_tint)), pdf);
}

FUNCTION BsdfSample conductor_sample(const global Material *m, BsdfPoint point, vec2 u, float choice) {
    const Conductor c = conductor_view(m);
    const int again = choice < conductor_lost(m, c, point.wo.z);
    const vec3 wi = where(again, shadowed_direction(c.alpha * c.alpha, u), mirrored_by_facet(conductor_facets(c), point.wo, u));
    const Spectrum ideal = times(conductor_fresnel(point.wo.z, c.eta, c.k), tinted(c.specular, point.specular_tint));
    return sample_or_mirror(!is_rough(c.alpha), ideal, point.wo, sample_towards(wi, conductor_eval(m, point, wi)));
}

FUNCTION Spectrum conductor_albedo(const global Material *m, Tints tint) {
    const Conductor c = conductor_view(m);
    return times(conductor_fresnel(1.0f, c.eta, c.k), tinted(c.specular, tint.specular));
}
