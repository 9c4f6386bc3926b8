// How likely a path would have asked for the light that a ray finds where it meets nothing.
#pragma once
#include "kernels/core/scene.cl"
#include "kernels/lights/environment.h"
#include "kernels/textures/panorama.cl"

/// The density with which a path asks for light from this direction, as environment_sample chooses it [1/sr]; 0 in scenes whose background is no
/// light.
FUNCTION float environment_density(Scene scene, vec3 direction) {
    const vec2 place = panorama_place(direction, scene.header->background_turn);
    const uint columns = max(scene.header->environment_columns, 1u), rows = max(scene.header->environment_rows.count, 1u);
    const uint column = min((uint)(int)((place.x - floor(place.x)) * (float)(int)columns), columns - 1u);
    const uint row = min((uint)(int)((1.0f - place.y) * (float)(int)rows), rows - 1u);
    const float density = SCENE_ARRAY(scene, EnvironmentCell, environment_cells)[row * columns + column].density;
    return scene.header->environment_density > 0.0f ? scene.header->environment_density * density : 0.0f;
}
