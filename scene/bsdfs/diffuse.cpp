/// Lambert's surface in scene files.
#include "kernels/bsdfs/diffuse.h"

#include "scene/bsdfs/make.h"
#include "scene/parameters.h"
#include "scene/textures/textured.h"
#include "scene/vectors.h"

namespace brandung {

Material read_diffuse(const Parameters &parameters, Scene &scene) {
    const TexturedSpectrum reflectance = read_textured_fraction(parameters, "reflectance", Spectrum(0.5f), scene);
    Material material = material_of_kind("diffuse", largest(reflectance.value) > 0 ? MATERIAL_LIT | MATERIAL_DIFFUSE : 0, Diffuse{reflectance.value});
    material.diffuse_texture = reflectance.texture;
    read_emission(parameters, material);
    return material;
}

}  // namespace brandung
