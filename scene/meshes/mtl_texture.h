/// Textures as statements of material libraries name them.
#pragma once
#include <map>
#include <string>
#include <string_view>

#include "scene/image.h"

namespace brandung {

struct MtlTexture {
    std::string file;          ///< as it is written; empty: there is no texture
    vec2 scale{1}, offset{0};  ///< the place in the picture is scale * uv + offset
    bool clamps = false;       ///< beyond its edges lies the edge, else the picture again
    Encoding encoding = Encoding::automatic;

    bool is_placed_as(const MtlTexture &other) const { return scale == other.scale && offset == other.offset; }
};

/// From the line of a statement behind its key: a name, which may have blanks, and options on both sides of it, by this table. What is not used is
/// a counted warning.
///
/// | option | becomes |
/// |---|---|
/// | -s u v w, -o u v w | `scale` and `offset`; w has no effect |
/// | -clamp on | `clamps` |
/// | -blendu, -blendv, -boost, -texres, -bm | nothing: they are about how pictures are filtered, or bumps |
/// | -colorspace | `encoding`, of sRGB or linear |
/// | -mm, -t, -cc, -type, -imfchan | not used, a warning |
MtlTexture read_mtl_texture(std::string_view line, std::map<std::string, uint> &warnings);

}  // namespace brandung
