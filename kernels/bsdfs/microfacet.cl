// Rough surfaces of ideal facets (Walter et al., EGSR 2007; Heitz, JCGT 3(2) 2014), isotropic, about z. `alpha` > 0 is the root mean square of slopes
// of Beckmann's distribution, and the width of GGX.
#pragma once
#include "generated/constants.h"
#include "kernels/bsdfs/bsdf.h"
#include "kernels/core/math.cl"
#include "kernels/core/warp.cl"

#define DISTRIBUTION_GGX 0u
#define DISTRIBUTION_BECKMANN 1u

typedef struct {
    float alpha;
    uint distribution;  ///< DISTRIBUTION_*
} Microfacets;

/// Whether a surface is rough, and by which distribution. Of those that no surface of the scene has, FACETS has no bit, and nothing is computed.
FUNCTION bool is_rough(float alpha) { return FACETS != 0u && alpha > 0.0f; }
FUNCTION bool is_beckmann(Microfacets m) {
    const bool has_ggx = (FACETS >> DISTRIBUTION_GGX & 1u) != 0u, has_beckmann = (FACETS >> DISTRIBUTION_BECKMANN & 1u) != 0u;
    return has_beckmann && (!has_ggx || m.distribution == DISTRIBUTION_BECKMANN);
}

/// Squared sine of the angle to z, which 1 - z² would round away near it.
FUNCTION float sine_squared(vec3 w) { return fma(w.x, w.x, w.y * w.y); }

/// D(h) [1/sr], of a unit vector h with z >= 0.
FUNCTION float facet_density(Microfacets m, vec3 h) {
    const float alpha2 = m.alpha * m.alpha, z2 = h.z * h.z, across = sine_squared(h), q = fma(alpha2, z2, across);
    const float ggx = alpha2 / (q * q) * INVERSE_PI;
    const float beckmann = exponential(-across / (alpha2 * z2)) / maximum(alpha2 * z2 * z2, 0x1p-126f) * INVERSE_PI;  // 0 / 0 at z = 0
    return is_beckmann(m) ? beckmann : ggx;
}

/// Area that the facets' visible sides have in direction w, z >= 0, per area of the surface: w.z / G1(w), finite at grazing angles too (Smith).
FUNCTION float visible_area(Microfacets m, vec3 w) {
    const float spread = m.alpha * sqrt(sine_squared(w));
    const float ggx = 0.5f * (w.z + sqrt(fma(w.z, w.z, spread * spread)));
    const float a = spread > 0.0f ? w.z / spread : INFINITY, gaussian = exponential(-a * a);
    const float beckmann = fma(0.5f * w.z, 1.0f + error_function(a, gaussian), spread * gaussian * 0.282094792f);  // 1 / 2√π
    return is_beckmann(m) ? beckmann : ggx;
}

/// Of the facets that are visible from one direction, the part that is visible from the other too, wi.z > 0: G2(wo, wi) / G1(wo), of heights that
/// are correlated. `areas`: visible_area of wo (x) and wi (y).
FUNCTION float visible_from_both(vec2 areas, float wo_z, float wi_z) { return areas.x * wi_z / (areas.x * wi_z + areas.y * wo_z - wo_z * wi_z); }

/// A visible facet's normal: the cap of a sphere that is seen from w's stretched direction (Dupuy & Benyoub, CGF 42(8) 2023).
FUNCTION vec3 ggx_visible_normal(float alpha, vec3 w, vec2 u) {
    const vec3 stretched = unit(make3(alpha * w.x, alpha * w.y, w.z));
    // 1 - z and 1 + z of a point of the cap z > -stretched.z, without cancellation.
    const float below = u.x * (1.0f + stretched.z), radius = sqrt(maximum(below * (2.0f - below), 0.0f));
    const vec2 azimuth = turn(u.y);
    const vec3 h = make3(fma(radius, azimuth.x, stretched.x), fma(radius, azimuth.y, stretched.y), (1.0f - u.x) * (1.0f + stretched.z));
    return unit(make3(alpha * h.x, alpha * h.y, h.z));
}

/// A visible facet's normal. Slopes across w are normally distributed; of those along it, x alpha, the erf b of x has the distribution
/// 1 + b + t exp(-x²) / √π up to a factor, t = alpha tan of w's angle, up to x = 1 / t (Heitz & d'Eon, CGF 33(4) 2014; in b:
/// Jakob, 2014). It is concave in b, so that steps by Newton approach the solution from below; after two from the first guess, a fit of the form
/// of Jakob's, the distribution is met within 4e-6.
FUNCTION vec3 beckmann_visible_normal(float alpha, vec3 w, vec2 u) {
    const float sine = sqrt(sine_squared(w)), largest_erf = 0.99999994f;
    // Beyond 2^40 the distribution no longer changes.
    const float t = minimum(alpha * sine / maximum(w.z, 0x1p-126f), 0x1p40f), inverse = t > 0.0f ? 1.0f / t : INFINITY;
    const float gaussian = exponential(-inverse * inverse), end = error_function(inverse, gaussian), slope = t * 0.564189584f;  // t / √π
    const float wanted = u.x * (1.0f + end + slope * gaussian), s = 1.0f / fma(0.39f, inverse, 1.0f);
    const float guess = fma(s, fma(s, fma(s, 1.32475f, -2.01444f), 0.12828f), 1.0f);
    float b = end - (1.0f + end) * power(1.0f - u.x, guess);
#pragma unroll
    for (int step = 0; step < 2; ++step) {
        const float x = inverse_error_function(minimum(maximum(b, -largest_erf), largest_erf)), rise = 1.0f - t * x;
        const float missing = wanted - (1.0f + b) - slope * exponential(-x * x);
        b = rise > 0.0f ? minimum(b + missing / rise, end) : end;
    }
    const float along = inverse_error_function(minimum(maximum(b, -largest_erf), largest_erf));
    const float across = inverse_error_function(minimum(maximum(fma(2.0f, u.y, -1.0f), -largest_erf), largest_erf));
    const float cosine = sine > 0.0f ? w.x / sine : 1.0f, azimuth_sine = sine > 0.0f ? w.y / sine : 0.0f;
    const float x = cosine * along - azimuth_sine * across, y = azimuth_sine * along + cosine * across;
    return unit(make3(-alpha * x, -alpha * y, 1.0f));
}

/// Normal of a facet that is visible from w, z > 0, with density facet_density(h) max(w·h, 0) / visible_area(w).
FUNCTION vec3 visible_normal(Microfacets m, vec3 w, vec2 u) {
    const vec3 ggx = ggx_visible_normal(m.alpha, w, u), beckmann = beckmann_visible_normal(m.alpha, w, u);
    return where(is_beckmann(m), beckmann, ggx);
}

/// Direction that an ideal facet of normal h mirrors w into.
FUNCTION vec3 mirrored(vec3 w, vec3 h) { return minus(scaled(h, 2.0f * dot3(w, h)), w); }

/// Direction that a visible facet mirrors w into. Where no surface is rough, nobody wants to know.
FUNCTION vec3 mirrored_by_facet(Microfacets m, vec3 w, vec2 u) { return FACETS != 0u ? mirrored(w, visible_normal(m, w, u)) : w; }

/// Facets that mirror light from wi towards wo, whatever part of it; never stored.
typedef struct {
    float cosine;  ///< of the angle at a facet
    float value;   ///< f(wo, wi) cos of wi of facets that reflect everything [1/sr]
    float pdf;     ///< of wi, by a visible normal from wo that mirrors wo [1/sr]
} FacetReflection;

/// Of wi with z > 0.
FUNCTION FacetReflection reflected_by_facets(Microfacets m, vec3 wo, vec3 wi) {
    const vec3 h = unit(plus(wo, wi));
    vec2 areas;
    areas.x = visible_area(m, wo), areas.y = visible_area(m, wi);
    FacetReflection result;
    result.cosine = dot3(wo, h), result.pdf = facet_density(m, h) / (4.0f * areas.x);
    result.value = result.pdf * visible_from_both(areas, wo.z, wi.z);
    return result;
}

/// Fresnel's reflectance of unpolarised light at a conductor of index eta + i k.
FUNCTION float conductor_fresnel(float cosine, float eta, float k) {
    const float cosine2 = cosine * cosine, sine2 = maximum(1.0f - cosine2, 0.0f), t = (eta - k) * (eta + k) - sine2;
    // Squared magnitude and real part of the cosine inside times the index, the latter without cancellation.
    const float magnitude = sqrt(fma(t, t, 4.0f * (eta * k) * (eta * k)));
    const float real_part = t < 0.0f ? eta * k * sqrt(2.0f / (magnitude - t)) : sqrt(0.5f * (magnitude + t));
    const float twice = 2.0f * cosine * real_part;
    const float s = (magnitude + cosine2 - twice) / maximum(magnitude + cosine2 + twice, 0x1p-126f);  // 0 / 0 at cosine 0 of nothing
    const float parallel = fma(magnitude, cosine2, sine2 * sine2), difference = twice * sine2;
    return 0.5f * s * (1.0f + (parallel - difference) / maximum(parallel + difference, 0x1p-126f));
}

FUNCTION Spectrum conductor_fresnel(float cosine, Spectrum eta, Spectrum k) {
    return make3(conductor_fresnel(cosine, eta.x, k.x), conductor_fresnel(cosine, eta.y, k.y), conductor_fresnel(cosine, eta.z, k.z));
}
