// Stands for core/interior.cl in scenes without transparent materials: every ray is outside of everything, nothing is stored.
#pragma once
#include "kernels/core/scene.cl"

typedef struct {
    uint nothing;
} Interior;
typedef struct {
    float eta;
    uint priority;
    bool any;
} Medium;

FUNCTION Interior interior_load(const global uint *interiors, uint slot) { return (Interior){0u}; }
FUNCTION void interior_store(global uint *interiors, uint slot, Interior interior) {}
FUNCTION bool interior_contains(Interior interior, uint material) { return false; }
FUNCTION Interior interior_entered(Interior interior, uint material) { return interior; }
FUNCTION Interior interior_left(Interior interior, uint material) { return interior; }
FUNCTION Interior where(int c, Interior a, Interior b) { return a; }
FUNCTION Medium interior_medium(Interior interior, const global Material *materials) { return (Medium){1.0f, 0u, false}; }
