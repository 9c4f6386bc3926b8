// Stands for core/tints.cl in scenes without textures and vertex colours: nothing is multiplied, nothing is stored.
#pragma once
#include "kernels/core/load.cl"

FUNCTION Tints white_tints() {
    const Tints white = {{1.0f, 1.0f, 1.0f}, {1.0f, 1.0f, 1.0f}};
    return white;
}
FUNCTION Tints tints_at(const global Tints *tints, uint i) { return white_tints(); }
typedef uint TintColumns;
FUNCTION void store_tints(TintColumns *columns, uint c, Tints tints) {}
FUNCTION Tints column_tints(const TintColumns *columns, uint c) { return white_tints(); }
