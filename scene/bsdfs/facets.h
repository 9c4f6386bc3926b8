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
