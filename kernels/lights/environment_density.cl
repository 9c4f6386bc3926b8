// How likely a path would have asked for the light that a ray finds where it meets nothing.
#pragma once
#include "kernels/core/scene.cl"
#include "kernels/lights/environment.h"
#include "kernels/lights/environment_cells.cl"
#include "kernels/textures/panorama.cl"

/// The density with which a path asks for light from this direction, as environment_sample chooses it [1/sr]; 0 in scenes whose background is no
/// light.
FUNCTION float environment_density(Scene scene, vec3 direction) {
    const vec2 place = panorama_place(direction, scene.header->background_turn);
    const uint columns = max(scene.header->environment_columns, 1u), rows = max(scene.header->environment_row_count, 1u);
    const uint column = min((uint)(int)((place.x - floor(place.x)) * (float)(int)columns), columns - 1u);
    const uint row = min((uint)(int)((1.0f - place.y) * (float)(int)rows), rows - 1u);
    const global float *begin = environment_row_begins(scene, row, columns) + column;
    const float density = SCENE_ARRAY(scene, EnvironmentRow, environment_rows)[row].density * (begin[1] - begin[0]);
    return scene.header->environment_density > 0.0f ? scene.header->environment_density * density : 0.0f;
}
