/// Glass, water and the like in scene files.
#include "kernels/bsdfs/dielectric.h"

#include "scene/bsdfs/facets.h"
#include "scene/bsdfs/index_of_refraction.h"
#include "scene/bsdfs/make.h"
#include "scene/parameters.h"
#include "scene/vectors.h"

namespace brandung {

/// Has an inside, as far as light gets there.
Material read_dielectric(const Parameters &parameters, Scene &) {
    Dielectric dielectric{};
    dielectric.reflection = parameters.fraction("reflection", Spectrum(1));
    dielectric.transmission = parameters.fraction("transmission", Spectrum(1));
    const Facets facets = read_facets(parameters, 0);
    dielectric.alpha = facets.alpha, dielectric.distribution = facets.distribution;
    const bool transmits = largest(dielectric.transmission) > 0, scatters = transmits || largest(dielectric.reflection) > 0;
    const uint lobes = facets.alpha > 0 ? MATERIAL_LIT | MATERIAL_GLOSSY | flags_of(facets) : MATERIAL_IDEAL;
    const uint flags = (facets.alpha > 0 ? MATERIAL_LOSES : 0) | (transmits ? MATERIAL_TRANSMITS | MATERIAL_PASSES : 0) | (scatters ? lobes : 0);
    Material material = material_of_kind("dielectric", flags, dielectric);
    material.eta = read_index(parameters);
    material.priority = parameters.integer("priority", 0, 0, max_priority);
    read_emission(parameters, material);
    return material;
}

}  // namespace brandung
