// Stands for core/tints.cl in scenes without textures and vertex colours: nothing is multiplied, nothing is stored.
#pragma once
#include "kernels/core/load.cl"

FUNCTION Tints tints_at(const global Tints *tints, uint i) {
    const Tints white = {{1.0f, 1.0f, 1.0f}, {1.0f, 1.0f, 1.0f}};
    return white;
}
