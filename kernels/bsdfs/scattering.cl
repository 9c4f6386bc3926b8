// How the surfaces that a chunk of paths has met scatter light: a loop over the chunk for each kind of BSDF that is among them, since a switch would
// keep loops over items from becoming 16 wide. Stages that bring hits of one kind together leave one or two such loops to most chunks.
#pragma once
#include "generated/bsdfs.cl"
#include "generated/constants.h"
#include "generated/tints.cl"
#include "kernels/bsdfs/bsdf.h"
#include "kernels/core/columns.cl"
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/scene.h"

/// What a chunk's BSDFs need to know of their surfaces.
typedef struct {
    uint materials[ITEMS_PER_WORK_ITEM];  ///< their numbers
    uint kinds[ITEMS_PER_WORK_ITEM];      ///< a bit for each kind of BSDF; 0 where there is no surface
    Vec3Columns wo;                       ///< as of BsdfPoint, like the others
    float etas[ITEMS_PER_WORK_ITEM];
    TintColumns tints;
} BsdfColumns;

/// As if all were of the scene's first material, seen from straight above.
FUNCTION void clear(BsdfColumns *columns) {
    for (uint c = 0u; c < ITEMS_PER_WORK_ITEM; ++c) columns->materials[c] = columns->kinds[c] = 0u, columns->etas[c] = 1.0f;
    fill_columns(&columns->wo, make3(0.0f, 0.0f, 1.0f));
}

FUNCTION BsdfPoint bsdf_point(const BsdfColumns *columns, uint c) {
    const Tints tints = column_tints(&columns->tints, c);
    BsdfPoint point;
    point.wo = column_vec3(&columns->wo, c), point.eta = columns->etas[c];
    point.diffuse_tint = tints.diffuse, point.specular_tint = tints.specular;
    return point;
}

/// The bits of all kinds in the chunk.
FUNCTION uint all_kinds(const BsdfColumns *columns) {
    uint kinds = 0u;
    for (uint c = 0u; c < ITEMS_PER_WORK_ITEM; ++c) kinds |= columns->kinds[c];
    return kinds;
}

/// Where the scene has but one kind, all are of it, and nobody looks.
FUNCTION bool are_among(uint kinds, uint kind) { return ONE_BSDF || (kinds & 1u << kind) != 0u; }

/// By what samples are chosen, in [0, 1): `u` the direction within a lobe, `choices` the lobe.
typedef struct {
    float x[ITEMS_PER_WORK_ITEM], y[ITEMS_PER_WORK_ITEM], choices[ITEMS_PER_WORK_ITEM];
} RandomColumns;

FUNCTION void clear(RandomColumns *columns) {
    for (uint c = 0u; c < ITEMS_PER_WORK_ITEM; ++c) columns->x[c] = columns->y[c] = columns->choices[c] = 0.0f;
}

typedef struct {
    Vec3Columns wi, weights;
    float pdfs[ITEMS_PER_WORK_ITEM];
} SampleColumns;

FUNCTION BsdfSample column_sample(const SampleColumns *columns, uint c) {
    BsdfSample sample;
    sample.wi = column_vec3(&columns->wi, c), sample.weight = column_vec3(&columns->weights, c), sample.pdf = columns->pdfs[c];
    return sample;
}

FUNCTION void select_sample(SampleColumns *columns, uint c, bool is_selected, BsdfSample sample) {
    const BsdfSample other = column_sample(columns, c);
    store_column(&columns->wi, c, where(is_selected, sample.wi, other.wi));
    store_column(&columns->weights, c, where(is_selected, sample.weight, other.weight));
    columns->pdfs[c] = is_selected ? sample.pdf : other.pdf;
}

/// Samples of all BSDFs of the chunk; `kinds` are all of its kinds.
FUNCTION void sample_bsdfs(const global Material *materials, uint kinds, const BsdfColumns *points, const RandomColumns *random,
                           SampleColumns *samples) {
#define SAMPLE(KIND, View, name)                                                                                                     \
    if (are_among(kinds, KIND)) {                                                                                                    \
        FOR_EACH_COLUMN(c) {                                                                                                         \
            const vec2 u = {random->x[c], random->y[c]};                                                                             \
            const BsdfSample sample = name##_sample(materials + points->materials[c], bsdf_point(points, c), u, random->choices[c]); \
            select_sample(samples, c, are_among(points->kinds[c], KIND), sample);                                                    \
        }                                                                                                                            \
    }
    FOR_EACH_BSDF(SAMPLE)
#undef SAMPLE
}

typedef struct {
    Vec3Columns values;
    float pdfs[ITEMS_PER_WORK_ITEM];
} ValueColumns;

FUNCTION BsdfValue column_value(const ValueColumns *columns, uint c) {
    BsdfValue value;
    value.value = column_vec3(&columns->values, c), value.pdf = columns->pdfs[c];
    return value;
}

FUNCTION void select_value(ValueColumns *columns, uint c, bool is_selected, BsdfValue value) {
    const BsdfValue other = column_value(columns, c);
    store_column(&columns->values, c, where(is_selected, value.value, other.value));
    columns->pdfs[c] = is_selected ? value.pdf : other.pdf;
}

/// Values of all BSDFs of the chunk for light from `wi`, in the frames of their hits.
FUNCTION void evaluate_bsdfs(const global Material *materials, uint kinds, const BsdfColumns *points, const Vec3Columns *wi, ValueColumns *values) {
#define EVALUATE(KIND, View, name)                                                                                            \
    if (are_among(kinds, KIND)) {                                                                                             \
        FOR_EACH_COLUMN(c) {                                                                                                  \
            const BsdfValue value = name##_eval(materials + points->materials[c], bsdf_point(points, c), column_vec3(wi, c)); \
            select_value(values, c, are_among(points->kinds[c], KIND), value);                                                \
        }                                                                                                                     \
    }
    FOR_EACH_BSDF(EVALUATE)
#undef EVALUATE
}
