// The picture all around as a light.
#pragma once
#include "kernels/core/math.cl"
#include "kernels/core/scene.cl"
#include "kernels/lights/environment.h"
#include "kernels/lights/light.h"
#include "kernels/lights/light_random.cl"
#include "kernels/textures/panorama.cl"
#include "kernels/textures/texture.cl"

/// What the picture and its scale send from that direction. Lights of other kinds ask too, in scenes without a table, where directions are no
/// numbers: then a texel's worth of the arena is read, and does not count.
FUNCTION Spectrum environment_radiance(Scene scene, vec3 direction) {
    const bool known = scene.header->environment_rows.count > 0u;
    const TextureRecord record = SCENE_ARRAY(scene, TextureRecord, textures)[known ? scene.header->background_texture - 1u : 0u];
    TextureRecord picture;
    picture.offset = known ? record.offset : 0u, picture.flags = record.flags;
    picture.width = known ? record.width : 1u, picture.height = known ? record.height : 1u;
    const global ushort *texels = known ? scene.texels : (const global ushort *)scene.arena;
    const vec2 place = panorama_place(direction, scene.header->background_turn);
    vec2 uv;
    uv.x = known ? place.x : 0.5f, uv.y = known ? place.y : 0.5f;
    const Spectrum color = texture_color(texels, picture, uv), white = make3(1.0f, 1.0f, 1.0f);
    return times(scene.header->background, where(known, color, white));
}

/// Where in [begin, end) a number u lies, in [0, 1]; below its last digit, 2^-24, by chance.
FUNCTION float place_within(float begin, float end, float u, uint random) {
    return minimum(fma(unit_interval(random), 0x1p-24f, u - begin) / (end - begin), 1.0f);
}

/// The last of the records 0 to `last`, of `words` words each, whose first word is not above u: by halves, in steps from `first_step`, a power of
/// two.
FUNCTION uint last_begun(const global void *records, uint words, uint last, uint first_step, float u) {
    const global float *begins = (const global float *)records;
    uint found = 0u;
#pragma unroll
    for (uint step = first_step; step > 0u; step /= 2u) {
        const uint next = min(found + step, last);
        found = begins[next * words] <= u ? next : found;
    }
    return found;
}

/// Uniform in the row's and the cell's solid angle. Rows and columns are searched in as many steps whatever the picture is.
FUNCTION LightSample environment_sample(Scene scene, Light l, vec3 p, LightRandom random) {
    const global EnvironmentRow *rows = SCENE_ARRAY(scene, EnvironmentRow, environment_rows);
    const uint last_row = max(scene.header->environment_rows.count, 1u) - 1u;
    const uint row = last_begun(rows, 4u, last_row, MAX_ENVIRONMENT_ROWS / 2u, random.square.x);
    const EnvironmentRow chosen_row = rows[row];

    const uint columns = max(scene.header->environment_columns, 1u);
    const global EnvironmentCell *cells = SCENE_ARRAY(scene, EnvironmentCell, environment_cells) + row * columns;
    const uint column = last_begun(cells, 3u, columns - 1u, MAX_ENVIRONMENT_COLUMNS / 2u, random.square.y);
    const EnvironmentCell cell = cells[column];

    const float down = place_within(chosen_row.begin, chosen_row.end, random.square.x, hash(random.random + 6u));
    const float right = place_within(cell.begin, cell.end, random.square.y, hash(random.random + 7u));
    const float cosine = fma(down, chosen_row.low - chosen_row.high, chosen_row.high);
    const float sine = sqrt(maximum((1.0f - cosine) * (1.0f + cosine), 0.0f));
    const float turns = ((float)(int)column + right) / (float)(int)columns - 0.5f - scene.header->background_turn;
    const vec2 azimuth = turn(turns - floor(turns));
    LightSample sample;
    sample.direction = sample.ray_direction = make3(sine * azimuth.y, cosine, -sine * azimuth.x);
    sample.distance = INFINITY;
    sample.inverse_density = 4.0f * PI / cell.density;
    sample.irradiance = scaled(environment_radiance(scene, sample.direction), sample.inverse_density);
    return sample;
}
