// What look_up_textures has found out for item i.
#pragma once
#include "kernels/core/columns.cl"
#include "kernels/core/load.cl"

FUNCTION Tints tints_at(const global Tints *tints, uint i) {
    Tints result;
    result.diffuse = load(&tints[i].diffuse), result.specular = load(&tints[i].specular);
    result.diffuse.x = fabs(result.specular.z) >= 0.0f ? result.diffuse.x : NAN;  // reads the whole record: see SurfacePoint
    return result;
}

typedef struct {
    Vec3Columns diffuse, specular;
} TintColumns;

FUNCTION void store_tints(TintColumns *columns, uint c, Tints tints) {
    store_column(&columns->diffuse, c, tints.diffuse), store_column(&columns->specular, c, tints.specular);
}
FUNCTION Tints column_tints(const TintColumns *columns, uint c) {
    Tints tints;
    tints.diffuse = column_vec3(&columns->diffuse, c), tints.specular = column_vec3(&columns->specular, c);
    return tints;
}
