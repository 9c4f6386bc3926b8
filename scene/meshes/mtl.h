/// Material libraries (.mtl) of OBJ files: what they say, and what it means for Whitted's surface.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace brandung {

/// One material as its library has it; what has no value is not there.
struct MtlMaterial {
    std::string name;
    std::optional<Spectrum> kd, ks, ke, tf;
    std::optional<float> ns, ni, d, tr;
    std::optional<float> roughness, metallic;  ///< Pr and Pm
    std::optional<int64> illum;
    std::string map_kd, map_ks;  ///< files of textures, as they are written
    std::string folder;          ///< of the library, from which they are found
};

/// In the order of the file. Throws SceneError `file:line: why`; what cannot be used is a counted warning.
std::vector<MtlMaterial> read_mtl(const std::string &file, std::map<std::string, uint> &warnings);

/// Whitted's surface for a material, by this table; `warnings` counts what is doubtful. T is what passes through: 1 - d where d < 1, else 1, times
/// Tf.
///
/// | statement | becomes |
/// |---|---|
/// | Kd | `diffuse` and `ambient`, linear Rec. 709; missing: 0.6. Ka is not used: it is often 0 or that of a light |
/// | Ks, Ns | `specular`, `exponent` (at least 1; missing: 50); none with illum 0 and 1 |
/// | map_Kd, map_Ks | textures by which `diffuse` and `specular` are multiplied, which are 1 where Kd or Ks is missing or 0; of their options none |
/// | Ke | `emission` |
/// | d, Tr = 1 - d | with illum 0 to 3, 5, 8: `transmission` 1 - d with `eta` 1, and all else times d. Of both, d counts |
/// | illum 3, 5, 8 | mirror: `reflection` Ks, `diffuse` times 1 - Ks |
/// | illum 4, 7, 9 | glass: `fresnel`, `reflection` 1, `transmission` T, `eta` Ni (missing: 1.5), `diffuse` times 1 - T |
/// | illum 6 | the same without Fresnel's reflectance: `reflection` Ks |
/// | Tf | filters what glass lets through; where it is below 0.5 in all parts it is opacity, as 3ds Max writes it, and counts as 1 - Tf |
/// | Pr, Pm | roughness r, metallic m: `specular` from 0.04 to Kd by m, `exponent` (2 / r^4 - 2) / 4, `reflection` Kd m (1 - r)^2, `diffuse` times
/// 1 - m (1 - r)^2: reflections that Whitted's method cannot blur are given to the diffuse part |
Material make_material(const MtlMaterial &mtl, std::map<std::string, uint> &warnings);

/// Of what no file gives a material: grey, or the colours of its vertices, with a little highlight.
Material default_mesh_material(bool has_colors);

}  // namespace brandung
