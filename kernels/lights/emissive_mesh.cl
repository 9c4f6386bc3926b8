// Emissive mesh: points uniform by area in the part of the mesh that is the cell.
#pragma once
#include "kernels/core/load.cl"
#include "kernels/core/morton.cl"
#include "kernels/core/scene.cl"
#include "kernels/core/warp.cl"
#include "kernels/lights/emission.cl"
#include "kernels/lights/stratum.cl"

FUNCTION EmissiveMesh emissive_mesh_view(Light l) {
    EmissiveMesh light;
    light.emission = emission_view(l);
    light.first_face = l.words[7], light.faces = l.words[8];
    return light;
}

/// A face chosen by area. Rows of lights of other kinds are evaluated too, and not selected: their numbers are kept within the array.
FUNCTION const global EmissiveFace *emissive_mesh_face(Scene scene, EmissiveMesh light, uint random) {
    const global EmissiveFace *faces = SCENE_ARRAY(scene, EmissiveFace, emissive_faces);
    const uint last = max(scene.header->emissive_faces.count, 1u) - 1u;
    const uint entry = (uint)((uint64)hash(random + 2u) * light.faces >> 32);
    const global EmissiveFace *face = faces + min(light.first_face + entry, last);
    const uint chosen = unit_interval(hash(random + 3u)) < face->kept ? entry : face->alias;
    return faces + min(light.first_face + chosen, last);
}

/// A place on the face's part of Morton's curve, and chance within the curve's steps of 2^-16.
FUNCTION vec2 curve_point(const global EmissiveFace *face, LightRandom random) {
    const uint64 steps = (uint64)(face->last - face->first) + 1u;
    const uint place = face->first + (uint)((uint64)random.curve * steps >> 32);
    vec2 point;
    point.x = ((float)(int)even_bits(place) + unit_interval(hash(random.random + 4u))) * 0x1p-16f;
    point.y = ((float)(int)even_bits(place >> 1) + unit_interval(hash(random.random + 5u))) * 0x1p-16f;
    return point;
}

FUNCTION LightSample emissive_mesh_sample(Scene scene, Light l, vec3 p, LightRandom random) {
    const EmissiveMesh light = emissive_mesh_view(l);
    const global EmissiveFace *face = emissive_mesh_face(scene, light, random.random);
    const vec2 square = curve_point(face, random), folded = triangle_of_square(square);
    const float s = face->folded > 0.0f ? folded.x : square.x, t = face->folded > 0.0f ? folded.y : square.y;
    const vec3 q = plus(load(&face->corner), plus(scaled(load(&face->u), s), scaled(load(&face->v), t)));
    return emission_sample(scene, light.emission, PLACE_OF_LIGHT(light.emission, random), p,
                           emissive_point(q, load(&face->normal), face->error, 1.0f));
}
