// An interface between two media, smooth or rough (Walter et al., EGSR 2007). Light that more than one facet meets is left by a lobe of its own on
// either side (after Kulla & Conty, SIGGRAPH course 2017), so that none is lost.
#pragma once
#include "generated/losses.cl"
#include "kernels/bsdfs/bsdf.h"
#include "kernels/bsdfs/dielectric.h"
#include "kernels/bsdfs/microfacet.cl"
#include "kernels/bsdfs/sample.cl"
#include "kernels/bsdfs/shadowed.cl"
#include "kernels/core/load.cl"
#include "kernels/core/refraction.cl"
#include "kernels/core/scene.h"

FUNCTION Dielectric dielectric_view(const global Material *m) {
    Dielectric d;
    d.reflection = load_floats(m->words), d.transmission = load_floats(m->words + 3);
    d.alpha = as_float(m->words[6]), d.distribution = m->words[7];
    return d;
}

/// Whether it is a single direction that light is mirrored into, and one that it is refracted into. Between media of one index nothing bends it.
FUNCTION bool is_smooth(Dielectric d, float eta) { return !HAS_LOSSES || (!is_rough(d.alpha) | (eta == 1.0f)); }

/// The part of light that a facet mirrors.
FUNCTION float facet_reflectance(float cosine, float cosine_squared_beyond, float eta) {
    return eta == 1.0f ? 0.0f : fresnel(cosine, cosine_squared_beyond, eta);
}

/// How the light that several facets meet is divided.
typedef struct {
    float loss;               ///< part of the light along wo
    float chance;             ///< of these lobes when a direction is drawn: at most 3/4, as of the rest some goes nowhere
    float mirrored;           ///< part of `loss` that comes back
    float mean, mean_beyond;  ///< of the losses on either side
    Losses losses, losses_beyond;
} Diffusion;

/// Shares of both sides are such that the lobe through the interface is reciprocal: proportional, on each side, to 1 over its index squared times its
/// mean loss. Of the side where the product is less, as much passes as if the light met the interface once more, from everywhere (Fresnel's mean
/// reflectance: fit by Kulla & Conty for the side of the lower index).
FUNCTION Diffusion diffusion_of(const global Material *m, Dielectric d, float eta, float cosine) {
    const float ratio = eta > 1.0f ? eta : 1.0f / eta, passes = 1.0f - (ratio - 1.0f) / fma(1.00071f, ratio, 4.08567f);
    Diffusion r;
    r.losses = losses_of(m, d.alpha, eta), r.losses_beyond = losses_of(m, d.alpha, 1.0f / eta);
    r.mean = mean_loss(r.losses), r.mean_beyond = mean_loss(r.losses_beyond);
    const float here = eta * eta * r.mean;
    r.loss = is_smooth(d, eta) ? 0.0f : loss(r.losses, cosine), r.chance = minimum(r.loss, 0.75f);
    r.mirrored = 1.0f - passes * minimum(here, r.mean_beyond) / here;
    return r;
}

/// Width of the directions drawn from a lobe whose losses have this mean. Where media are nearly alike these are next to nothing but at the most
/// grazing angles. Losses that fall with the cosine z are at most mean / z², so that a sample's weight is at most some logarithm.
FUNCTION float lobe_width(float mean) { return 0.5f * mean; }

/// Of both kinds of lobes, for radiance without the material's factors and eta²; pdf too is that of `sample`.
typedef struct {
    float value, pdf;
} Lobes;

/// How much the facets that hide refracted light on one side have to do with those that hide it on the other: 0 where it is the same light that is
/// hidden, 1 where one says nothing of the other. Light that is not bent passes all facets as if they were not there, and would be charged twice for
/// what is hidden from it on its way. Of azimuths of mirrored light: van Ginneken et al., Applied Optics 37(1), 1998; here of the bend.
FUNCTION float masking_apart(vec3 wo, vec3 wi) {
    const vec3 bend = plus(wo, wi);
    const float x = 4.41f * sqrt(dot3(bend, bend));
    return x / (x + 1.0f);
}

/// Of the facets that are visible from wo, the part whose light leaves on the other side, as visible_from_both; the same where `apart` is 1.
FUNCTION float refracted_by_visible(vec2 areas, float wo_z, float wi_z, float apart) {
    const float a = areas.x * wi_z, b = areas.y * wo_z;
    return a / fma(apart, minimum(a, b) - wo_z * wi_z, maximum(a, b));
}

/// Light that one facet sends from wi to wo.
FUNCTION Lobes facet_lobes(Dielectric d, float eta, vec3 wo, vec3 wi) {
    const Microfacets facets = {d.alpha, d.distribution};
    const bool mirrors = wi.z > 0.0f;
    const vec3 sum = plus(scaled(wo, mirrors ? 1.0f : eta), wi);
    const float inverse_length = copysign(1.0f / sqrt(dot3(sum, sum)), sum.z);
    const vec3 h = scaled(sum, inverse_length), above = make3(wi.x, wi.y, fabs(wi.z));
    const float cosine = dot3(wo, h), cosine_beyond = -dot3(wi, h);
    const float reflectance = facet_reflectance(cosine, refracted_cosine_squared(cosine, eta), eta);
    vec2 areas;
    areas.x = visible_area(facets, wo), areas.y = visible_area(facets, above);
    // Solid angle of h per one of wi, times the cosine that turns the facets' density into that of the visible ones.
    const float mirrored = 0.25f * reflectance, refracted = (1.0f - reflectance) * cosine * cosine_beyond * inverse_length * inverse_length;
    const bool faces = (cosine > 0.0f) & (mirrors | (cosine_beyond > 0.0f));
    Lobes r;
    r.pdf = faces ? facet_density(facets, h) / areas.x * (mirrors ? mirrored : refracted) : 0.0f;
    r.value = faces ? r.pdf * refracted_by_visible(areas, wo.z, above.z, mirrors ? 1.0f : masking_apart(wo, wi)) : 0.0f;
    return r;
}

/// The same with what several facets send.
FUNCTION Lobes all_lobes(Dielectric d, Diffusion diffusion, float eta, vec3 wo, vec3 wi) {
    const bool mirrors = wi.z > 0.0f;
    const float cosine = fabs(wi.z), share = mirrors ? diffusion.mirrored : 1.0f - diffusion.mirrored;
    const float mean = mirrors ? diffusion.mean : diffusion.mean_beyond;
    const float loss_of_wi = loss(where(mirrors, diffusion.losses, diffusion.losses_beyond), cosine);
    Lobes r = facet_lobes(d, eta, wo, wi);
    r.value = fma(diffusion.loss * share * cosine, loss_of_wi * INVERSE_PI / mean, r.value);
    r.pdf = fma(diffusion.chance * share, shadowed_density(lobe_width(mean), cosine), (1.0f - diffusion.chance) * r.pdf);
    return r;
}

FUNCTION Spectrum dielectric_factor(Dielectric d, float eta, bool mirrors) { return where(mirrors, d.reflection, scaled(d.transmission, eta * eta)); }

FUNCTION BsdfValue dielectric_eval(const global Material *m, BsdfPoint point, vec3 wi) {
    const Dielectric d = dielectric_view(m);
    const Lobes lobes = all_lobes(d, diffusion_of(m, d, point.eta, point.wo.z), point.eta, point.wo, wi);
    const bool nothing = is_smooth(d, point.eta) | (wi.z == 0.0f);
    BsdfValue result;
    result.value = scaled(dielectric_factor(d, point.eta, wi.z > 0.0f), nothing ? 0.0f : lobes.value);
    result.pdf = nothing ? 0.0f : lobes.pdf;
    return result;
}

/// Where a facet sends light from.
typedef struct {
    vec3 wi;
    bool mirrors;
} FacetSample;

FUNCTION FacetSample facet_sample(Dielectric d, float eta, vec3 wo, vec2 u, float choice) {
    const Microfacets facets = {d.alpha, d.distribution};
    const vec3 h = where(is_smooth(d, eta), make3(0.0f, 0.0f, 1.0f), visible_normal(facets, wo, u));
    const float cosine = dot3(wo, h), cosine2 = refracted_cosine_squared(cosine, eta);
    const vec3 beyond = where(eta == 1.0f, negate(wo), refracted(wo, h, cosine, cosine2, eta));
    FacetSample sample;
    sample.mirrors = choice < facet_reflectance(cosine, cosine2, eta);
    sample.wi = where(sample.mirrors, mirrored(wo, h), beyond);
    return sample;
}

/// What a facet mirrors into the surface, or refracts out of it, goes nowhere, which a direction within the surface stands for: the diffuse lobes
/// have that light.
FUNCTION vec3 dielectric_direction(const global Material *m, Dielectric d, float eta, vec3 wo, vec2 u, float choice) {
    const Diffusion diffusion = diffusion_of(m, d, eta, wo.z);
    const bool is_diffuse = HAS_LOSSES && choice < diffusion.chance;
    const float rest = HAS_LOSSES ? minimum((choice - diffusion.chance) / (1.0f - diffusion.chance), 0.99999994f) : choice;
    const FacetSample facet = facet_sample(d, eta, wo, u, rest);
    const bool stays = choice < diffusion.chance * diffusion.mirrored;
    const vec3 up = shadowed_direction(lobe_width(stays ? diffusion.mean : diffusion.mean_beyond), u), diffuse = where(stays, up, negate(up));
    const bool leaves = facet.mirrors ? facet.wi.z > 0.0f : facet.wi.z < 0.0f;
    return where(is_diffuse, diffuse, where(leaves, facet.wi, make3(1.0f, 0.0f, 0.0f)));
}

FUNCTION BsdfSample dielectric_sample(const global Material *m, BsdfPoint point, vec2 u, float choice) {
    const Dielectric d = dielectric_view(m);
    const vec3 wi = dielectric_direction(m, d, point.eta, point.wo, u, choice);
    const bool smooth = is_smooth(d, point.eta);
    BsdfSample sample = sample_towards(wi, dielectric_eval(m, point, wi));
    sample.weight = where(smooth, dielectric_factor(d, point.eta, wi.z > 0.0f), sample.weight);
    sample.pdf = where(smooth, INFINITY, sample.pdf);
    return sample;
}

FUNCTION Spectrum dielectric_albedo(const global Material *m, Tints tint) {
    const Dielectric view = dielectric_view(m);
    return maximum(view.reflection, view.transmission);
}
