// Light that a rough dielectric's facets take from each other: what is left of the light that meets one facet only.
#pragma once
#include "kernels/bsdfs/dielectric.h"
#include "kernels/bsdfs/loss_table.h"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/scene.h"

#define HAS_LOSSES 1

/// A place between those of a table's axis.
typedef struct {
    uint first;
    float part;  ///< of the way to the next
} TablePlace;

/// At `x`, in [0, 1] or it is brought there, of `count` places.
FUNCTION TablePlace table_place(float x, uint count) {
    const float along = maximum(minimum(x, 1.0f), 0.0f) * (float)(int)(count - 1u);
    TablePlace place;
    place.first = min((uint)(int)along, count - 2u);
    place.part = along - (float)(int)place.first;
    return place;
}

/// The losses of light from one side of an interface.
typedef struct {
    const global LossRow *row;  ///< of the next smaller ratio of indices in the table; that of the next larger one follows
    float part;                 ///< of the way there
    float alpha;
} Losses;

FUNCTION Losses where(int c, Losses a, Losses b) {
    Losses r;
    r.row = c ? a.row : b.row, r.part = c ? a.part : b.part, r.alpha = c ? a.alpha : b.alpha;
    return r;
}

/// The table of a material. Kernels ask that of others too, and do nothing with what they get: they find numbers in the records behind theirs.
FUNCTION const global LossTable *loss_table(const global Material *m) {
    return (const global LossTable *)(m->words + ((m->flags & MATERIAL_LOSES) != 0u ? m->words[DIELECTRIC_LOSSES_WORD] : 0u));
}

/// `eta`: index of refraction on the side that the light comes from over that beyond.
FUNCTION Losses losses_of(const global Material *m, float alpha, float eta) {
    const bool leaves = eta > 1.0f;
    const float q = sqrt(maximum((leaves ? eta : 1.0f / eta) - 1.0f, 0.0f));
    const TablePlace place = table_place(1.0f - 0.5f / (q + 0.5f), LOSS_ETAS);
    Losses losses;
    losses.row = loss_table(m)->rows[leaves ? 1 : 0] + place.first, losses.part = place.part, losses.alpha = alpha;
    return losses;
}

/// The part of the light that is lost, of light that arrives at this cosine.
FUNCTION float loss(Losses losses, float cosine) {
    const TablePlace place = table_place(cosine * (1.0f + losses.alpha) / (cosine + losses.alpha), LOSS_COSINES);
    const global float *near = losses.row[0].at + place.first, *far = losses.row[1].at + place.first;
    const float a = fma(place.part, near[1] - near[0], near[0]), b = fma(place.part, far[1] - far[0], far[0]);
    return fma(losses.part, b - a, a);
}

/// Its mean over light from everywhere.
FUNCTION float mean_loss(Losses losses) { return fma(losses.part, losses.row[1].mean - losses.row[0].mean, losses.row[0].mean); }
