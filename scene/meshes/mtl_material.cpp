/// What a material of a library means for Whitted's surface: the table of mtl.h.
#include <algorithm>
#include <cmath>

#include "scene/bsdfs/bsdf.h"
#include "scene/bsdfs/index_of_refraction.h"
#include "scene/meshes/mtl.h"
#include "scene/vectors.h"

namespace brandung {
namespace {

constexpr float default_diffuse = 0.6f, default_exponent = 50, default_eta = 1.5f;
constexpr float largest_exponent = 1e4f;
constexpr float smooth_reflectance = 0.04f;  ///< of what is no metal, seen straight on
constexpr int64 default_illum = 2;

Spectrum at_most_one(Spectrum s) { return glm::min(s, Spectrum(1)); }

bool is_mirror(int64 illum) { return illum == 3 || illum == 5 || illum == 8; }
bool is_glass(int64 illum) { return illum == 4 || illum == 6 || illum == 7 || illum == 9; }
bool has_highlight(int64 illum) { return illum > 1; }

/// A texture shows as it is where nothing but black is said beside it.
Spectrum reflectance(const std::optional<Spectrum> &given, const MtlTexture &texture, float missing) {
    const bool by_texture = !texture.file.empty() && given.value_or(Spectrum(0)) == Spectrum(0);
    return by_texture ? Spectrum(1) : given.value_or(Spectrum(missing));
}

/// Whether decimal fractions in a file mean the same.
bool same(float a, float b) { return std::abs(a - b) <= 1e-3f; }

/// How much of what is behind the surface it hides.
float opacity(const MtlMaterial &mtl, std::map<std::string, uint> &warnings) {
    if (mtl.d && mtl.tr && !same(*mtl.d, 1 - *mtl.tr)) ++warnings["material whose d and Tr contradict each other: d counts"];
    const float opacity = std::clamp(mtl.d ? *mtl.d : mtl.tr ? 1 - *mtl.tr : 1, 0.0f, 1.0f);
    if (opacity == 0 && !is_glass(mtl.illum.value_or(default_illum))) ++warnings["material that is invisible (d 0 or Tr 1)"];
    return opacity;
}

/// Glass: what does not pass it is diffuse, but what its filter keeps is lost.
void make_glass(const MtlMaterial &mtl, float opaque, Whitted &whitted, std::map<std::string, uint> &warnings) {
    const Spectrum tf = at_most_one(mtl.tf.value_or(Spectrum(1)));
    const bool is_opacity = same(tf.x, tf.y) && same(tf.x, tf.z) && largest(tf) < 0.5f;
    if (is_opacity) ++warnings["material of glass whose Tf is grey below 0.5: taken as opacity"];
    const float through = (opaque < 1 ? 1 - opaque : 1) * (is_opacity ? 1 - tf.x : 1);
    whitted.fresnel = mtl.illum != 6;
    whitted.reflection = whitted.fresnel ? Spectrum(1) : at_most_one(mtl.ks.value_or(Spectrum(0)));
    whitted.transmission = through * (is_opacity ? Spectrum(1) : tf);
    whitted.diffuse *= 1 - through;
}

/// Roughness and metallic: no more light leaves a point than falls on it.
void make_metallic(const MtlMaterial &mtl, Whitted &whitted, std::map<std::string, uint> &warnings) {
    const float roughness = std::clamp(mtl.roughness.value_or(0.5f), 0.0f, 1.0f), metallic = std::clamp(mtl.metallic.value_or(0), 0.0f, 1.0f);
    const float squared = std::max(roughness * roughness, 1e-3f);
    float sharp = metallic * (1 - roughness) * (1 - roughness);
    if (sharp > 0 && !mtl.map_kd.file.empty()) {
        ++warnings["metal with a texture, which cannot colour mirror images: its reflections are diffuse"];
        sharp = 0;
    }
    whitted.reflection = at_most_one(whitted.diffuse) * sharp;
    whitted.specular = glm::mix(Spectrum(smooth_reflectance), whitted.diffuse, sharp);
    whitted.exponent = std::clamp((2 / (squared * squared) - 2) / 4, 1.0f, largest_exponent);
    whitted.diffuse *= (1 - smooth_reflectance) * (1 - sharp);
}

float index_of_glass(const MtlMaterial &mtl, std::map<std::string, uint> &warnings) {
    const float index = mtl.ni.value_or(0);
    if (index > 0 && !is_permitted_index(index)) ++warnings["material of glass whose Ni is not from 0.01 to 100: taken as 1.5"];
    return is_permitted_index(index) ? index : default_eta;
}

}  // namespace

Material make_material(const MtlMaterial &mtl, std::map<std::string, uint> &warnings) {
    const int64 illum = mtl.illum.value_or(default_illum);
    const float opaque = opacity(mtl, warnings);
    Whitted whitted{};
    whitted.diffuse = reflectance(mtl.kd, mtl.map_kd, default_diffuse);
    whitted.specular = has_highlight(illum) ? reflectance(mtl.ks, mtl.map_ks, 0) : Spectrum(0);
    whitted.exponent = std::max(mtl.ns.value_or(default_exponent), 1.0f);
    if (mtl.roughness || mtl.metallic) make_metallic(mtl, whitted, warnings);
    float eta = 1;
    if (is_mirror(illum) && !mtl.metallic) {
        whitted.reflection = at_most_one(mtl.ks.value_or(Spectrum(1)));
        whitted.diffuse *= Spectrum(1) - whitted.reflection;
    }
    if (is_glass(illum)) {
        make_glass(mtl, opaque, whitted, warnings);
        eta = index_of_glass(mtl, warnings);
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
