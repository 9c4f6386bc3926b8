// What surfaces shine with of themselves.
#pragma once
#include "kernels/core/items.h"
#include "kernels/core/load.cl"
#include "kernels/core/scene.cl"

/// Radiance of the side that a surface point with these flags, SURFACE_..., is on.
FUNCTION Spectrum emitted(const global Material *material, uint surface_flags) {
    const uint dark = (surface_flags & SURFACE_BACK) != 0u ? MATERIAL_DARK_BACK : MATERIAL_DARK_FRONT;
    return where((material->flags & dark) != 0u, make3(0.0f, 0.0f, 0.0f), load(&material->emission));
}
