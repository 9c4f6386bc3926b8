// Stands for core/tints.cl in scenes without textures and vertex colours: nothing is multiplied, nothing is stored.
#pragma once
#include "kernels/core/load.cl"
#include "kernels/core/white_tints.cl"

FUNCTION Tints tints_at(const global Tints *tints, uint i) { return white_tints(); }
typedef uint TintColumns;
FUNCTION void store_tints(TintColumns *columns, uint c, Tints tints) {}
FUNCTION Tints column_tints(const TintColumns *columns, uint c) { return white_tints(); }
