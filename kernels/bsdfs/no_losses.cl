// Stands for bsdfs/losses.cl in scenes without rough dielectrics: nothing is stored.
#pragma once
#include "kernels/core/scene.h"

#define HAS_LOSSES 0

typedef struct {
    float mean;
} Losses;

FUNCTION Losses where(int c, Losses a, Losses b) { return a; }
FUNCTION Losses losses_of(const global Material *m, float alpha, float eta) {
    Losses losses;
    losses.mean = 1.0f;
    return losses;
}
FUNCTION float loss(Losses losses, float cosine) { return 0.0f; }
FUNCTION float mean_loss(Losses losses) { return losses.mean; }
