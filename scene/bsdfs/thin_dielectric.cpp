/// Thin sheets of glass in scene files.
#include "kernels/bsdfs/thin_dielectric.h"

#include "scene/bsdfs/index_of_refraction.h"
#include "scene/bsdfs/make.h"
#include "scene/parameters.h"
#include "scene/vectors.h"

namespace brandung {

/// Has no inside: nothing goes into a medium.
Material read_thin_dielectric(const Parameters &parameters, Scene &) {
    ThinDielectric sheet{};
    sheet.reflection = parameters.fraction("reflection", Spectrum(1));
    sheet.transmission = parameters.fraction("transmission", Spectrum(1));
    const bool scatters = largest(sheet.reflection) > 0 || largest(sheet.transmission) > 0;
    Material material = material_of_kind("thin_dielectric", MATERIAL_PASSES | (scatters ? MATERIAL_IDEAL : 0), sheet);
    material.eta = read_index(parameters);
    read_emission(parameters, material);
    return material;
}

}  // namespace brandung
