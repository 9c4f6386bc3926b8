// Stands for core/interior.cl in scenes without transparent materials: every ray is outside of everything, nothing is stored.
#pragma once
#include "kernels/core/scene.cl"

FUNCTION void interior_copy(const global uint *from, uint i, global uint *to, uint k) {}
FUNCTION void interior_choose(bool c, const global uint *either, uint i, const global uint *other, uint j, global uint *to, uint k) {}
FUNCTION void store_eta_of_chosen(global float *etas, uint i, const global Material *chosen) {}
FUNCTION float interface_eta(const global float *etas, uint i, const global Material *material) { return 1.0f / material->eta; }
