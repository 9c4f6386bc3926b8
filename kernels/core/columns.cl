// Records fetched for a chunk of items, word by word: a gather of one word of 16 records takes longer than to load four words of each, whole.
#pragma once
#include "kernels/core/items.cl"
#include "kernels/core/lanes_1.cl"
#include "kernels/core/scene.h"
#include "kernels/core/transpose.cl"

/// numbers[c] = list[begin + c], for all c: after the last item it is the first record.
FUNCTION void list_numbers(const global uint *list, Chunk chunk, uint *numbers) {
    for (uint c = 0u; c < ITEMS_PER_WORK_ITEM; ++c) numbers[c] = c < chunk.items ? list[chunk.begin + c] : 0u;
}

/// Records of up to 16 words, one for each item of a chunk.
typedef struct {
    float words[16][ITEMS_PER_WORK_ITEM];
} Columns;

/// Words first to first + 3 of a record, as far as it has them; it has an even number.
FUNCTION float4 four_words(const global float *record, uint words, uint first) {
    return first + 4u <= words ? vload4(0, record + first) : (float4)(vload2(0, record + first), 0.0f, 0.0f);
}

/// Of records of `words` words, a constant, that of number numbers[c] for each item c of the chunk's first `count`. Up to the next multiple of 16,
/// numbers[c] must be that of some record too.
FUNCTION void fetch_columns(const global void *records, uint words, const uint *numbers, uint count, Columns *columns) {
    const global float *first = (const global float *)records;
#ifdef CPU
    for (uint c = 0u; c < count; c += 16u) {
#pragma unroll
        for (uint f = 0u; f < words; f += 4u) {
            float16 rows[4], fields[4];
#pragma unroll
            for (uint r = 0u; r < 4u; ++r) {
                const uint *number = numbers + c + r;
                rows[r] = (float16)(four_words(first + words * number[0], words, f), four_words(first + words * number[4], words, f),
                                    four_words(first + words * number[8], words, f), four_words(first + words * number[12], words, f));
            }
            transpose_fields(rows, fields);
#pragma unroll
            for (uint w = 0u; w < 4u; ++w) vstore16(fields[w], 0, columns->words[f + w] + c);
        }
    }
#else
    for (uint w = 0u; w < words; ++w) columns->words[w][0] = first[words * numbers[0] + w];
#endif
}

/// A vector for each item of a chunk.
typedef struct {
    float x[ITEMS_PER_WORK_ITEM], y[ITEMS_PER_WORK_ITEM], z[ITEMS_PER_WORK_ITEM];
} Vec3Columns;

FUNCTION vec3 column_vec3(const Vec3Columns *columns, uint c) { return make3(columns->x[c], columns->y[c], columns->z[c]); }
FUNCTION void store_column(Vec3Columns *columns, uint c, vec3 v) { columns->x[c] = v.x, columns->y[c] = v.y, columns->z[c] = v.z; }
FUNCTION void fill_columns(Vec3Columns *columns, vec3 v) {
    for (uint c = 0u; c < ITEMS_PER_WORK_ITEM; ++c) store_column(columns, c, v);
}

FUNCTION float column_float(const Columns *columns, uint word, uint c) { return columns->words[word][c]; }
FUNCTION uint column_word(const Columns *columns, uint word, uint c) { return as_uint(columns->words[word][c]); }
FUNCTION vec3 column_vec3(const Columns *columns, uint word, uint c) {
    return make3(columns->words[word][c], columns->words[word + 1u][c], columns->words[word + 2u][c]);
}

FUNCTION Ray ray_of_columns(const Columns *columns, uint c) {
    Ray ray;
    ray.origin = column_vec3(columns, 0u, c), ray.t_max = column_float(columns, 3u, c);
    ray.direction = column_vec3(columns, 4u, c), ray.tag = column_word(columns, 7u, c);
    return ray;
}
FUNCTION Path path_of_columns(const Columns *columns, uint c) {
    Path path;
    path.throughput = column_vec3(columns, 0u, c);
    path.slot = column_word(columns, 3u, c), path.branch = column_word(columns, 4u, c), path.depth = column_word(columns, 5u, c);
    return path;
}
FUNCTION ShadingRecord shading_of_columns(const Columns *columns, uint c) {
    ShadingRecord record;
    record.kind = column_word(columns, 0u, c), record.material = column_word(columns, 1u, c);
#pragma unroll
    for (uint w = 0u; w < 14u; ++w) record.words[w] = column_word(columns, w + 2u, c);
    return record;
}
FUNCTION Light light_of_columns(const Columns *columns, uint c) {
    Light light;
    light.kind = column_word(columns, 0u, c);
#pragma unroll
    for (uint w = 0u; w < 15u; ++w) light.words[w] = column_word(columns, w + 1u, c);
    return light;
}
