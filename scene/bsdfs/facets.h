/// Facets of rough surfaces: what their kinds compute once per material.
#pragma once
#include <functional>

#include "kernels/bsdfs/angle_curve.h"
#include "kernels/core/portable.h"

namespace brandung {

class Parameters;

/// As Microfacets of kernels/bsdfs/microfacet.cl, but 0 is a smooth surface.
struct Facets {
    float alpha;
    uint distribution;
};

/// "roughness", from 0 to 1, of which alpha is the square (Burley 2012), and "distribution". Surfaces below 0.01 are smooth: a float cannot tell
/// normals of their facets apart.
Facets read_facets(const Parameters &parameters, float roughness);

/// MATERIAL_... by which kernels know that they are needed: none of a smooth surface.
uint flags_of(const Facets &facets);

/// Area that the facets' visible sides have in a direction at this cosine, per area of the surface: cosine / G1 (Smith).
double visible_area(const Facets &facets, double cosine);
/// Of the facets that are visible in one direction, the part that is visible in the other too, which is on the same side of the surface or on the
/// other one, over the `area` that is visible in the first; their heights are correlated. `other` is above 0.
inline double also_visible(double cosine, double area, double other, double other_area) {
    return other / (area * other + (other_area - other) * cosine);
}

/// A slope that facets have.
struct FacetSlope {
    double z, radius;  ///< of their normals
    double weight;     ///< in integrals over w of what is asked of facets per area of the surface that is below them
};
/// That beyond which a part of the facets lies that goes with w from 0 to 1, at both ends so smoothly that it takes roots there away: D and the
/// measure cancel.
FacetSlope facet_slope(const Facets &facets, double w);

/// Of light at an angle of this cosine.
using Reflectance = std::function<double(double cosine)>;

/// Of facets with this reflectance, single scattering: reflected over arriving light. Quadrature, within 1e-3.
double reflectance_of(const Facets &facets, const Reflectance &of_facet, double cosine);

/// Any function of the cosine.
AngleCurve curve_of(const Facets &facets, const std::function<double(double cosine)> &function);
/// What the curve gives, as the kernels have it.
double value_of(const AngleCurve &curve, const Facets &facets, double cosine);

/// Of diffuse light.
double mean_of(const Reflectance &reflectance);

}  // namespace brandung
