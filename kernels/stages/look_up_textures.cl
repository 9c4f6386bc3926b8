// From hits to the colours that pictures and vertices give them. Only in scenes with textures, vertex colours or a picture as background.
#include "generated/instances.cl"
#include "kernels/core/load.cl"
#include "kernels/core/white_tints.cl"
#include "kernels/primitives/primitive.cl"
#include "kernels/textures/numbered.cl"
#include "kernels/textures/panorama.cl"

/// Of the chunk's rays that have met nothing, if there are any, the colour of the picture all around; of all others white.
FUNCTION void look_around(Scene scene, const global uint *list, uint count, const global Ray *rays, const global Hit *hits, global Tints *tints) {
    const Chunk chunk = chunk_of(count);
    bool any = false;
    for (uint i = chunk.begin; i < chunk.begin + chunk.items; ++i) any |= hits[i].primitive == NO_HIT;
    if (!any || scene.header->background_texture == 0u) {
        FOR_EACH_ITEM(i, count) {
            tints[i] = white_tints();
        }
        return;
    }
    const TextureRecord picture = SCENE_ARRAY(scene, TextureRecord, textures)[scene.header->background_texture - 1u];
    FOR_EACH_ITEM(i, count) {
        const Ray ray = load(rays + list[i]);
        const Hit hit = load(hits + i);
        const bool is_miss = (hit.primitive == NO_HIT) | (hit.t != hit.t);  // reads the whole record: see SurfacePoint
        const Spectrum color = texture_color(scene.texels, picture, panorama_place(ray.direction, scene.header->background_turn));
        Tints result = white_tints();
        result.diffuse = where(is_miss, color, result.diffuse);
        tints[i] = result;
    }
}

FUNCTION Tints tints_of_hit(Scene scene, const global Material *material, Ray ray, Hit hit, Placement place) {
    const Ray inner = ray_in_group(scene, place, ray);
    const Pattern pattern = primitive_pattern(scene, SCENE_ARRAY(scene, ShadingRecord, shading)[hit.primitive], inner, hit);
    Tints tints;
    tints.diffuse = times(pattern.color, color_of(scene, material->diffuse_texture, pattern.uv));
    tints.specular = color_of(scene, material->specular_texture, pattern.uv);
    return tints;
}

/// tints[i] belongs to ray live[first + i] and its hit, which is in instance instances[i] where scenes have some.
kernel void look_up_textures(SCENE_PARAMS, const global Texel *restrict scene_texels, LIVE_PARAMS, const global Ray *restrict rays,
                             const global Hit *restrict hits, const global uint *restrict instances, const global SurfacePoint *restrict points,
                             global Tints *restrict tints) {
    const Scene scene = SCENE_WITH_TEXELS;
    const bool has_vertex_colors = scene.header->vertex_colors.count > 0u;
    look_around(scene, live + first, count, rays, hits, tints);
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const global Material *material = SCENE_ARRAY(scene, Material, materials) + points[i].material;
        const bool has_pictures = (material->diffuse_texture | material->specular_texture) != 0u;
        if (hits[i].primitive == NO_HIT || !(has_pictures | has_vertex_colors)) continue;
        tints[i] = tints_of_hit(scene, material, rays[live[first + i]], hits[i], instance_at(instances, i));
    }
}
