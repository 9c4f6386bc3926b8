// Light that a rough dielectric's facets take from each other: what is left of the light that meets one facet only.
#pragma once
#include "kernels/bsdfs/dielectric_losses.cl"
#include "kernels/core/lanes_1.cl"

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

/// The losses of one interface, as functions of the angle: rows of the table around its alpha and eta.
typedef struct {
    float alpha;
    uint first;  ///< number in the table
    float part_alpha, part_eta;
} LossRows;

/// `eta`: index of refraction on the side that the light comes from over that beyond. Ratios beyond 2.78 count as that.
FUNCTION LossRows loss_rows(uint distribution, float alpha, float eta) {
    const bool leaves = eta > 1.0f;
    const float contrast = 1.0f - (leaves ? 1.0f / eta : eta);
    const TablePlace at_alpha = table_place(sqrt(alpha), LOSS_ALPHAS), at_eta = table_place(1.25f * sqrt(contrast), LOSS_ETAS);
    const uint part = (min(distribution, 1u) * 2u + (leaves ? 1u : 0u)) * LOSS_ETAS;
    LossRows rows;
    rows.alpha = alpha;
    rows.first = ((part + at_eta.first) * LOSS_ALPHAS + at_alpha.first) * (LOSS_COSINES + 1u);
    rows.part_alpha = at_alpha.part, rows.part_eta = at_eta.part;
    return rows;
}

/// Between the numbers at `column` of the rows.
FUNCTION float loss_at(LossRows rows, uint column) {
    const constant uint *losses = dielectric_losses + rows.first + column;
    const uint next_alpha = LOSS_COSINES + 1u, next_eta = LOSS_ALPHAS * next_alpha;
    const float a = (float)(int)losses[0], b = (float)(int)losses[next_alpha];
    const float c = (float)(int)losses[next_eta], d = (float)(int)losses[next_eta + next_alpha];
    const float near = fma(rows.part_alpha, b - a, a), far = fma(rows.part_alpha, d - c, c);
    return fma(rows.part_eta, far - near, near);
}

/// Of light that arrives at this cosine, the part that leaves neither by one mirroring nor by one refraction. Columns are even in a function of the
/// cosine over alpha: small losses hardly depend on anything else.
FUNCTION float loss(LossRows rows, float cosine) {
    const TablePlace place = table_place(cosine * (1.0f + rows.alpha) / (cosine + rows.alpha), LOSS_COSINES);
    const float a = loss_at(rows, place.first), b = loss_at(rows, place.first + 1u);
    return 0.001f * fma(place.part, b - a, a);
}

/// Its mean over light from everywhere, which is nearly proportional to alpha.
FUNCTION float mean_loss(LossRows rows) { return 1e-6f * rows.alpha * loss_at(rows, LOSS_COSINES); }
