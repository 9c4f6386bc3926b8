// What look_up_textures has found out for item i.
#pragma once
#include "kernels/core/load.cl"

FUNCTION Tints tints_at(const global Tints *tints, uint i) {
    Tints result;
    result.diffuse = load(&tints[i].diffuse), result.specular = load(&tints[i].specular);
    result.diffuse.x = fabs(result.specular.z) >= 0.0f ? result.diffuse.x : NAN;  // reads the whole record: see SurfacePoint
    return result;
}
