#include "scene/bsdfs/facets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernels/core/scene.h"
#include "scene/parameters.h"

namespace brandung {
namespace {

using std::numbers::pi;

constexpr uint beckmann = 1;
constexpr float least_roughness = 0.01f;
constexpr int nodes = 32, steps = 64;

/// Of the facets' normals, the squared slope beyond which this part lies.
double squared_slope(const Facets &facets, double beyond) {
    const double unit = facets.distribution == beckmann ? -std::log(beyond) : (1 - beyond) / beyond;
    return unit * facets.alpha * facets.alpha;
}

/// Of kernels/bsdfs/angle_curve.h.
double scale_of(const Facets &facets) { return facets.alpha / (1 + 3.0 * facets.alpha); }
double position_of(const Facets &facets, double cosine) {
    const double s = scale_of(facets);
    return 2 * cosine * (1 + s) / (cosine + s) - 1;
}
double cosine_at(const Facets &facets, double position) {
    const double s = scale_of(facets), part = (position + 1) / 2 / (1 + s);
    return std::min(s * part / (1 - part), 1.0);
}

}  // namespace

Facets read_facets(const Parameters &parameters, float roughness) {
    roughness = parameters.not_negative("roughness", roughness);
    if (roughness > 1) parameters.fail("roughness", fmt::format("must be from 0 to 1, got {:g}", roughness));
    return {roughness < least_roughness ? 0 : roughness * roughness, parameters.choice("distribution", {"ggx", "beckmann"}, 0)};
}

uint flags_of(const Facets &facets) { return facets.alpha > 0 ? MATERIAL_FACETS << facets.distribution : 0; }

/// As in kernels/bsdfs/microfacet.cl.
double visible_area(const Facets &facets, double cosine) {
    const double spread = facets.alpha * std::sqrt((1 - cosine) * (1 + cosine));
    if (facets.distribution != beckmann) return (cosine + std::sqrt(cosine * cosine + spread * spread)) / 2;
    if (cosine > 6 * spread) return cosine;  // what is beyond a double's rounding
    const double a = cosine / spread;
    return cosine * (1 + std::erf(a)) / 2 + spread * std::exp(-a * a) / (2 * std::sqrt(pi));
}

FacetSlope facet_slope(const Facets &facets, double w) {
    const double slope2 = squared_slope(facets, w * w * w * (10 + w * (6 * w - 15))), z = 1 / std::sqrt(1 + slope2);
    return {z, std::sqrt(slope2) * z, 30 * w * w * (1 - w) * (1 - w)};
}

/// Of normals by their slope and azimuth.
double reflectance_of(const Facets &facets, const Reflectance &of_facet, double cosine) {
    const double sine = std::sqrt((1 - cosine) * (1 + cosine)), area = visible_area(facets, cosine);
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const auto [z, radius, weight] = facet_slope(facets, (i + 0.5) / steps);
        for (int j = 0; j < steps; ++j) {
            const double at_facet = radius * std::cos(pi * (j + 0.5) / steps) * sine + z * cosine, beyond = 2 * at_facet * z - cosine;
            if (at_facet <= 0 || beyond <= 0) continue;
            const double both = also_visible(cosine, area, beyond, visible_area(facets, std::min(beyond, 1.0)));
            sum += weight / (steps * steps) * at_facet / z * both * of_facet(at_facet);
        }
    }
    return sum;
}

AngleCurve curve_of(const Facets &facets, const std::function<double(double cosine)> &function) {
    double terms[CURVE_TERMS] = {};
    for (int j = 0; j < nodes; ++j) {
        const double angle = pi * (j + 0.5) / nodes, value = function(cosine_at(facets, std::cos(angle)));
        for (int k = 0; k < CURVE_TERMS; ++k) terms[k] += (k == 0 ? 1 : 2) * value * std::cos(k * angle) / nodes;
    }
    AngleCurve curve;
    std::copy(terms, terms + CURVE_TERMS, curve.terms);
    return curve;
}

double value_of(const AngleCurve &curve, const Facets &facets, double cosine) {
    const double angle = std::acos(std::clamp(position_of(facets, cosine), -1.0, 1.0));
    double sum = 0;
    for (int k = 0; k < CURVE_TERMS; ++k) sum += curve.terms[k] * std::cos(k * angle);
    return sum;
}

double mean_of(const Reflectance &reflectance) {
    constexpr int angles = 1024;
    double sum = 0;
    for (int i = 0; i < angles; ++i) {
        const double cosine = (i + 0.5) / angles;
        sum += 2 * cosine * reflectance(cosine) / angles;
    }
    return sum;
}

}  // namespace brandung
