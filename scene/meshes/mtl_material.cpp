/// What a material of a library means for Whitted's surface: the table of mtl.h.
#include <algorithm>
#include <cmath>

#include "scene/bsdfs/bsdf.h"
#include "scene/meshes/mtl.h"
#include "scene/vectors.h"

namespace brandung {
namespace {

constexpr float default_diffuse = 0.6f, default_exponent = 50, default_eta = 1.5f;
constexpr float largest_exponent = 1e4f;

Spectrum at_most_one(Spectrum s) { return glm::min(s, Spectrum(1)); }

bool is_mirror(int64 illum) { return illum == 3 || illum == 5 || illum == 8; }
bool is_glass(int64 illum) { return illum == 4 || illum == 6 || illum == 7 || illum == 9; }
bool has_highlight(int64 illum) { return illum > 1; }

/// A texture shows as it is where nothing but black is said beside it.
Spectrum reflectance(const std::optional<Spectrum> &given, const std::string &texture, float missing) {
    const bool by_texture = !texture.empty() && given.value_or(Spectrum(0)) == Spectrum(0);
    return by_texture ? Spectrum(1) : given.value_or(Spectrum(missing));
}

/// How much of what is behind the surface it hides.
float opacity(const MtlMaterial &mtl, std::map<std::string, uint> &warnings) {
    if (mtl.d && mtl.tr && *mtl.d != 1 - *mtl.tr) ++warnings["material whose d and Tr contradict each other: d counts"];
    const float opacity = std::clamp(mtl.d ? *mtl.d : mtl.tr ? 1 - *mtl.tr : 1, 0.0f, 1.0f);
    if (opacity == 0) ++warnings["material that is invisible (d 0 or Tr 1)"];
    return opacity;
}

Spectrum filter(const MtlMaterial &mtl, std::map<std::string, uint> &warnings) {
    const Spectrum tf = at_most_one(mtl.tf.value_or(Spectrum(1)));
    if (largest(tf) >= 0.5f) return tf;
    ++warnings["material of glass whose Tf is below 0.5: taken as opacity"];
    return Spectrum(1) - tf;
}

void make_metallic(Whitted &whitted, float roughness, float metallic) {
    const float sharp = metallic * (1 - roughness) * (1 - roughness);
    const float squared = std::max(roughness * roughness, 1e-3f);
    whitted.specular = glm::mix(Spectrum(0.04f), whitted.diffuse, metallic);
    whitted.exponent = std::clamp((2 / (squared * squared) - 2) / 4, 1.0f, largest_exponent);
    whitted.reflection = at_most_one(whitted.diffuse) * sharp;
    whitted.diffuse *= 1 - sharp;
}

}  // namespace

Material make_material(const MtlMaterial &mtl, std::map<std::string, uint> &warnings) {
    const int64 illum = mtl.illum.value_or(2);
    const float opaque = opacity(mtl, warnings);
    Whitted whitted{};
    whitted.diffuse = reflectance(mtl.kd, mtl.map_kd, default_diffuse);
    whitted.specular = has_highlight(illum) ? reflectance(mtl.ks, mtl.map_ks, 0) : Spectrum(0);
    whitted.exponent = std::max(mtl.ns.value_or(default_exponent), 1.0f);
    if (mtl.roughness || mtl.metallic)
        make_metallic(whitted, std::clamp(mtl.roughness.value_or(0.5f), 0.0f, 1.0f), std::clamp(mtl.metallic.value_or(0), 0.0f, 1.0f));
    float eta = 1;
    if (is_mirror(illum)) {
        whitted.reflection = at_most_one(mtl.ks.value_or(Spectrum(1)));
        whitted.diffuse *= Spectrum(1) - whitted.reflection;
    }
    if (is_glass(illum)) {
        whitted.fresnel = illum != 6;
        whitted.reflection = whitted.fresnel ? Spectrum(1) : at_most_one(mtl.ks.value_or(Spectrum(0)));
        whitted.transmission = filter(mtl, warnings) * (opaque < 1 ? 1 - opaque : 1);
        whitted.diffuse *= Spectrum(1) - whitted.transmission;
        eta = mtl.ni.value_or(0) > 0 ? *mtl.ni : default_eta;
    } else if (opaque < 1) {
        for (Spectrum *part : {&whitted.diffuse, &whitted.specular, &whitted.reflection}) *part *= opaque;
        whitted.transmission = Spectrum(1 - opaque);
    }
    whitted.ambient = whitted.diffuse;
    Material material = make_material(whitted);
    material.eta = eta;
    material.emission = mtl.ke.value_or(Spectrum(0));
    return material;
}

Material default_mesh_material(bool has_colors) {
    const Spectrum diffuse(has_colors ? 1 : default_diffuse);
    const Whitted whitted = {.ambient = diffuse,
                             .diffuse = diffuse,
                             .specular = Spectrum(0.15f),
                             .reflection = Spectrum(0),
                             .transmission = Spectrum(0),
                             .exponent = 30,
                             .fresnel = 0};
    return make_material(whitted);
}

}  // namespace brandung
