/// Material libraries (.mtl) of OBJ files: what they say, and what it means for Whitted's surface.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/meshes/mtl_texture.h"
#include "scene/scene.h"

namespace brandung {

/// One material as its library has it; what has no value is not there.
struct MtlMaterial {
    std::string name;
    std::optional<Spectrum> kd, ks, ke, tf;
    std::optional<float> ns, ni, d, tr;
    std::optional<float> roughness, metallic;  ///< Pr and Pm
    std::optional<int64> illum;
    MtlTexture map_kd, map_ks;
    std::string folder;  ///< of the library, from which textures are found
};

/// In the order of the file. Throws SceneError `file:line: why`; what cannot be used is a counted warning.
std::vector<MtlMaterial> read_mtl(const std::string &file, std::map<std::string, uint> &warnings);

/// Whitted's surface for a material, by this table; `warnings` counts what is doubtful. t is the share that passes glass: 1 - d where d < 1, else 1.
///
/// | statement | becomes |
/// |---|---|
/// | Kd | `diffuse` and `ambient`, linear Rec. 709; missing: 0.6. Ka is not used: it is often 0 or that of a light |
/// | Ks, Ns | `specular`, `exponent` (at least 1; missing: 50); none with illum 0 and 1 |
/// | map_Kd, map_Ks | textures by which `diffuse` and `specular` are multiplied, which are 1 where Kd or Ks is missing or 0 |
/// | Ke | `emission` |
/// | d, Tr = 1 - d | with illum 0 to 3, 5, 8: `transmission` 1 - d with `eta` 1, and all else times d. Of both, d counts |
/// | illum 3, 5, 8 without Pm | mirror: `reflection` Ks, `diffuse` times 1 - Ks |
/// | illum 4, 7, 9 | glass: `fresnel`, `reflection` 1, `transmission` t, `eta` Ni (missing: 1.5), `diffuse` times 1 - t |
/// | illum 6 | the same without Fresnel's reflectance: `reflection` Ks |
/// | Tf | filters what glass lets through: `transmission` t Tf; grey below 0.5 it is opacity, as 3ds Max writes it, and t is times 1 - Tf instead |
/// | Pr, Pm | roughness r, metallic m, of which s = m (1 - r)^2 is sharp: `reflection` s Kd, `specular` from 0.04 to Kd by s, `exponent`
/// (2 / r^4 - 2) / 4, `diffuse` times 0.96 (1 - s): reflections that Whitted's method cannot blur are given to the diffuse part, and with map_Kd
/// all, since pictures do not colour mirrors |
Material make_material(const MtlMaterial &mtl, std::map<std::string, uint> &warnings);

/// Of what no file gives a material: grey, or the colours of its vertices, with a little highlight.
Material default_mesh_material(bool has_colors);

}  // namespace brandung
