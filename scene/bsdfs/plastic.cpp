/// A coated diffuse surface in scene files.
#include "kernels/bsdfs/plastic.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "scene/bsdfs/facets.h"
#include "scene/bsdfs/index_of_refraction.h"
#include "scene/bsdfs/make.h"
#include "scene/parameters.h"
#include "scene/textures/textured.h"
#include "scene/vectors.h"

namespace brandung {
namespace {

static_assert(offsetof(Plastic, coat) == PLASTIC_COAT_WORD * sizeof(uint));

double fresnel(double cosine, double eta) {
    const double beyond = std::sqrt(eta * eta - (1 - cosine) * (1 + cosine));
    const double s = (cosine - beyond) / (cosine + beyond), p = (eta * eta * cosine - beyond) / (eta * eta * cosine + beyond);
    return (s * s + p * p) / 2;
}

/// What follows from the boundary, of index `eta` over what surrounds it.
void add_boundary(Plastic &plastic, const Facets &facets, double eta) {
    const Reflectance of_facet = [&](double cosine) { return fresnel(cosine, eta); };
    plastic.eta = static_cast<float>(1 / eta);
    plastic.alpha = facets.alpha, plastic.distribution = facets.distribution;
    const auto over_smooth = [&](double cosine) { return facets.alpha > 0 ? reflectance_of(facets, of_facet, cosine) / of_facet(cosine) : 1; };
    plastic.coat = curve_of(facets, over_smooth);
    const double passes = 1 - mean_of([&](double cosine) { return std::clamp(of_facet(cosine) * value_of(plastic.coat, facets, cosine), 0.0, 1.0); });
    plastic.scale = static_cast<float>(1 / (passes * std::numbers::pi));
    // By reciprocity, of diffuse light from either side the same part of the radiance over eta² passes.
    plastic.internal = static_cast<float>(1 - passes / (eta * eta));
}

}  // namespace

Material read_plastic(const Parameters &parameters, Scene &scene) {
    Plastic plastic{};
    const TexturedSpectrum diffuse = read_textured_fraction(parameters, "diffuse", Spectrum(0.5f), scene);
    const float eta = read_index(parameters);
    if (!(eta > 1)) parameters.fail("eta", "must be above 1");
    plastic.diffuse = diffuse.value;
    plastic.nonlinear = parameters.boolean("nonlinear", false);
    const Facets facets = read_facets(parameters, 0);
    add_boundary(plastic, facets, eta);
    const bool is_diffuse = largest(diffuse.value) > 0;
    const uint flags = (facets.alpha > 0 || is_diffuse ? MATERIAL_LIT | MATERIAL_GLOSSY : 0) | (is_diffuse ? MATERIAL_DIFFUSE : 0) |
                       (facets.alpha > 0 ? flags_of(facets) : MATERIAL_IDEAL);
    Material material = material_of_kind("plastic", flags, plastic);
    material.diffuse_texture = diffuse.texture;
    read_emission(parameters, material);
    return material;
}

}  // namespace brandung
