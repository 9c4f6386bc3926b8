// The picture all around as a light.
#pragma once
#include "kernels/core/math.cl"
#include "kernels/core/scene.cl"
#include "kernels/lights/environment.h"
#include "kernels/lights/environment_cells.cl"
#include "kernels/lights/light.h"
#include "kernels/lights/light_random.cl"
#include "kernels/textures/panorama.cl"
#include "kernels/textures/texture.cl"

/// What the picture and its scale send from that direction. Lights of other kinds ask too, in scenes without a table, where directions are no
/// numbers: then a texel's worth of the arena is read, and does not count.
FUNCTION Spectrum environment_radiance(Scene scene, vec3 direction) {
    const bool known = scene.header->environment_row_count > 0u;
    const TextureRecord record = SCENE_ARRAY(scene, TextureRecord, textures)[known ? scene.header->background_texture - 1u : 0u];
    TextureRecord picture;
    picture.offset = known ? record.offset : 0u, picture.flags = record.flags;
    picture.width = known ? record.width : 1u, picture.height = known ? record.height : 1u;
    const global Texel *texels = known ? scene.texels : (const global Texel *)scene.arena;
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

/// The last of entries `first` to `last` that is not above u, if each is followed by the next after so many words: by halves, in steps from
/// `first_step`, a power of two.
FUNCTION uint last_begun(const global float *begins, uint words, uint first, uint last, uint first_step, float u) {
    uint found = first;
#pragma unroll
    for (uint step = first_step; step > 0u; step /= 2u) {
        const uint next = min(found + step, last);
        found = begins[next * words] <= u ? next : found;
    }
    return found;
}

/// Which cell of the row the number u chooses.
FUNCTION uint environment_column(Scene scene, uint row, const global float *begins, uint columns, float u) {
    const uint marks = (columns + (ENVIRONMENT_MARK - 1u)) / ENVIRONMENT_MARK;
    const global float *row_marks = SCENE_ARRAY(scene, float, environment_marks) + row * marks;
    const uint mark = ENVIRONMENT_MARK * last_begun(row_marks, 1u, 0u, marks - 1u, MAX_ENVIRONMENT_MARKS / 2u, u);
    return last_begun(begins, 1u, mark, min(mark + ENVIRONMENT_MARK, columns) - 1u, ENVIRONMENT_MARK / 2u, u);
}

/// Uniform in the row's and the cell's solid angle. Rows and columns are searched in as many steps whatever the picture is.
FUNCTION LightSample environment_sample(Scene scene, Light l, vec3 p, LightRandom random) {
    const global EnvironmentRow *rows = SCENE_ARRAY(scene, EnvironmentRow, environment_rows);
    const uint last_row = max(scene.header->environment_row_count, 1u) - 1u, columns = max(scene.header->environment_columns, 1u);
    const uint row = last_begun((const global float *)rows, 3u, 0u, last_row, MAX_ENVIRONMENT_ROWS / 2u, random.square.x);
    const global EnvironmentRow *chosen_row = rows + row;
    const global float *begins = environment_row_begins(scene, row, columns);
    const uint column = environment_column(scene, row, begins, columns, random.square.y);
    const float begin = begins[column], end = begins[column + 1u], high = chosen_row[0].high;

    const float down = place_within(chosen_row[0].begin, chosen_row[1].begin, random.square.x, hash(random.random + 6u));
    const float right = place_within(begin, end, random.square.y, hash(random.random + 7u));
    const float cosine = fma(down, chosen_row[1].high - high, high);
    const float sine = sqrt(maximum((1.0f - cosine) * (1.0f + cosine), 0.0f));
    const float turns = ((float)(int)column + right) / (float)(int)columns - 0.5f - scene.header->background_turn;
    const vec2 azimuth = turn(turns - floor(turns));
    LightSample sample;
    sample.direction = sample.ray_direction = make3(sine * azimuth.y, cosine, -sine * azimuth.x);
    sample.distance = INFINITY;
    sample.inverse_density = 4.0f * PI / (chosen_row[0].density * (end - begin));
    sample.irradiance = scaled(environment_radiance(scene, sample.direction), sample.inverse_density);
    return sample;
}
