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
    std::string file;  ///< the library, from whose folder textures are found
    uint line = 0;     ///< of its name
};

/// In the order of the file. Throws SceneError `file:line: why`; what cannot be used is a counted warning of the scene.
std::vector<MtlMaterial> read_mtl(const std::string &file, Scene &scene);

/// Whitted's surface for a material, by the table in scene/formats/GUIDE.md; `warnings` counts what is doubtful. Beyond the table: colours are linear
/// Rec. 709; Ka is often 0 or that of a light; of `d` and `Tr`, d counts; grey Tf below 0.5 is opacity, as 3ds Max writes it, by which transmission
/// is multiplied as 1 - Tf. Of roughness r and metallic m, s = m (1 - r)^2 is sharp: `reflection` is s Kd, `specular` goes from 0.04 to Kd by s,
/// `exponent` is (2 / r^4 - 2) / 4, `diffuse` is multiplied by 0.96 (1 - s): reflections that Whitted's method cannot blur are given to the diffuse
/// part, and with map_Kd all, since pictures do not colour mirrors.
Material make_material(const MtlMaterial &mtl, std::map<std::string, uint> &warnings);

/// Of what no file gives a material: grey, or the colours of its vertices, with a little highlight.
Material default_mesh_material(bool has_colors);

}  // namespace brandung
