/// Materials from views of their words.
#pragma once
#include "scene/bsdfs/bsdf.h"
#include "scene/kinds.h"

namespace brandung {

/// Of a medium, in scene files.
inline constexpr uint max_priority = 1u << 24;

/// Of the kind called `name`, with flags MATERIAL_*; an index of refraction of 1, and nothing else.
template <class View> Material material_of_kind(const char *name, uint flags, const View &view) {
    Material material{};
    material.kind = kind_number(bsdf_kinds(), name);
    material.flags = flags;
    material.eta = 1;
    write_words(view, material.words);
    return material;
}

/// Radiance, and the sides that shine.
void read_emission(const Parameters &parameters, Material &material);

}  // namespace brandung
