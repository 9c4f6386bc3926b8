/// Whitted's material in scene files.
#include "scene/bsdfs/index_of_refraction.h"
#include "scene/bsdfs/make.h"
#include "scene/parameters.h"
#include "scene/scene.h"
#include "scene/textures/textured.h"
#include "scene/vectors.h"

namespace brandung {

Material make_material(const Whitted &whitted) {
    const bool is_diffuse = largest(whitted.diffuse) > 0, has_highlight = largest(whitted.specular) > 0;
    const bool reflects = largest(whitted.reflection) > 0, transmits = largest(whitted.transmission) > 0;
    const uint flags = (reflects ? MATERIAL_REFLECTS : 0) | (transmits ? MATERIAL_TRANSMITS | MATERIAL_PASSES : 0) |
                       (reflects || transmits ? MATERIAL_IDEAL : 0) | (is_diffuse || has_highlight ? MATERIAL_LIT : 0) |
                       (is_diffuse ? MATERIAL_DIFFUSE : 0) | (has_highlight ? MATERIAL_HIGHLIGHT : 0) |
                       (has_highlight || (reflects && is_diffuse) ? MATERIAL_GLOSSY : 0);
    return material_of_kind("whitted", flags, whitted);
}

Material read_whitted(const Parameters &parameters, Scene &scene) {
    Whitted whitted{};
    const TexturedSpectrum diffuse = read_textured(parameters, "diffuse", Spectrum(0.5f), scene);
    const TexturedSpectrum specular = read_textured(parameters, "specular", Spectrum(0), scene);
    whitted.diffuse = diffuse.value;
    // Of a texture the value is a factor, which may brighten a dark picture.
    if (diffuse.texture == 0 && largest(diffuse.value) > 1)
        ++scene.warnings["diffuse reflectance above 1: more light leaves than arrives; colours are from 0 to 1"];
    whitted.ambient = parameters.spectrum("ambient", whitted.diffuse);
    whitted.specular = specular.value;
    whitted.exponent = parameters.positive("exponent", 50.0f);
    // A secondary ray cannot have more energy than the ray that made it.
    whitted.reflection = parameters.fraction("reflection", Spectrum(0));
    whitted.transmission = parameters.fraction("transmission", Spectrum(0));
    whitted.fresnel = parameters.boolean("fresnel", false);
    Material material = make_material(whitted);
    material.diffuse_texture = diffuse.texture, material.specular_texture = specular.texture;
    material.eta = read_index(parameters);
    material.priority = parameters.integer("priority", 0, 0, max_priority);
    read_emission(parameters, material);
    return material;
}

}  // namespace brandung
