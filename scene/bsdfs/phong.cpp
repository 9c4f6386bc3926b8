/// Phong's surface of bounded energy in scene files.
#include "kernels/bsdfs/phong.h"

#include "scene/bsdfs/make.h"
#include "scene/parameters.h"
#include "scene/textures/textured.h"
#include "scene/vectors.h"

namespace brandung {

Material read_phong(const Parameters &parameters, Scene &scene) {
    const TexturedSpectrum diffuse = read_textured_fraction(parameters, "diffuse", Spectrum(0.5f), scene);
    const TexturedSpectrum specular = read_textured_fraction(parameters, "specular", Spectrum(0.2f), scene);
    // Of a texture the value is a factor, which may brighten a dark picture.
    const Spectrum all = (diffuse.texture == 0 ? diffuse.value : Spectrum(0)) + (specular.texture == 0 ? specular.value : Spectrum(0));
    if (largest(all) > 1) parameters.fail("specular", "with the diffuse reflectance more light would leave than arrives: their sum is at most 1");
    const ModifiedPhong phong{diffuse.value, specular.value, parameters.positive("exponent", 50.0f)};
    const uint flags =
        (largest(diffuse.value) > 0 ? MATERIAL_LIT | MATERIAL_DIFFUSE : 0) | (largest(specular.value) > 0 ? MATERIAL_LIT | MATERIAL_GLOSSY : 0);
    Material material = material_of_kind("phong", flags, phong);
    material.diffuse_texture = diffuse.texture, material.specular_texture = specular.texture;
    read_emission(parameters, material);
    return material;
}

}  // namespace brandung
