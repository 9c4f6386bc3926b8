/// Metal in scene files.
#include "kernels/bsdfs/conductor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

#include "scene/bsdfs/facets.h"
#include "scene/bsdfs/index_of_refraction.h"
#include "scene/bsdfs/make.h"
#include "scene/bsdfs/metals.h"
#include "scene/parameters.h"
#include "scene/textures/textured.h"
#include "scene/vectors.h"

namespace brandung {
namespace {

static_assert(offsetof(Conductor, lost) == CONDUCTOR_LOST_WORD * sizeof(uint));

Spectrum read_part(const Parameters &parameters, const char *name) {
    const Spectrum part = parameters.spectrum(name);
    if (largest(part) > max_metal_index)
        parameters.fail(name, fmt::format("must be at most {:g}, got {:g} (its fourth power must fit into a float)", max_metal_index, largest(part)));
    return part;
}

void read_index_of_metal(const Parameters &parameters, Conductor &conductor) {
    const bool has_index = parameters.has("eta") || parameters.has("k");
    if (has_index && parameters.has("metal"))
        parameters.fail("metal", "the material has both \"metal\" and \"eta\" or \"k\", but needs only \"metal\", or \"eta\" and \"k\"");
    if (!has_index && !parameters.has("metal")) parameters.fail("", "needs either \"metal\", or \"eta\" and \"k\"");
    if (has_index) {
        conductor.eta = read_part(parameters, "eta"), conductor.k = read_part(parameters, "k");
        return;
    }
    std::vector<std::string> names;
    for (const Metal &metal : metals()) names.emplace_back(metal.name);
    const Metal &metal = metals()[parameters.choice("metal", names)];
    conductor.eta = metal.eta, conductor.k = metal.k;
}

double fresnel(double cosine, std::complex<double> index) {
    const std::complex<double> beyond = std::sqrt(index * index - (1 - cosine) * (1 + cosine));
    const std::complex<double> s = (cosine - beyond) / (cosine + beyond);
    const std::complex<double> p = (index * index * cosine - beyond) / (index * index * cosine + beyond);
    return (std::norm(s) + std::norm(p)) / 2;
}

/// What is reflected more than once is reflected diffusely, and loses by the mean reflectance each time.
float multiple(double lost, double eta, double k) {
    const double part = mean_of([&](double cosine) { return fresnel(cosine, {eta, k}); });
    return static_cast<float>(part * part * (1 - lost) / ((1 - part * lost) * lost * std::numbers::pi));
}

void add_multiple_reflection(Conductor &conductor, const Facets &facets) {
    const auto everything = [](double) { return 1.0; };
    const auto root_of_lost = [&](double cosine) { return std::sqrt(std::max(1 - reflectance_of(facets, everything, cosine), 0.0)); };
    conductor.lost = curve_of(facets, root_of_lost);
    const double lost = mean_of([&](double cosine) {
        const double root = value_of(conductor.lost, facets, cosine);
        return std::min(root * root, 1.0);
    });
    for (int c = 0; c < 3; ++c) conductor.multiple[c] = multiple(lost, conductor.eta[c], conductor.k[c]);
}

}  // namespace

Material read_conductor(const Parameters &parameters, Scene &scene) {
    Conductor conductor{};
    read_index_of_metal(parameters, conductor);
    const TexturedSpectrum specular = read_textured_fraction(parameters, "specular", Spectrum(1), scene);
    const Facets facets = read_facets(parameters, 0);
    conductor.specular = specular.value;
    conductor.alpha = facets.alpha, conductor.distribution = facets.distribution;
    if (facets.alpha > 0) add_multiple_reflection(conductor, facets);
    const uint flags = facets.alpha > 0 ? MATERIAL_LIT | MATERIAL_GLOSSY | flags_of(facets) : MATERIAL_IDEAL;
    Material material = material_of_kind("conductor", largest(specular.value) > 0 ? flags : 0, conductor);
    material.specular_texture = specular.texture;
    read_emission(parameters, material);
    return material;
}

}  // namespace brandung
