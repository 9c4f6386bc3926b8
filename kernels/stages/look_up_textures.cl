// From hits to the colours that pictures and vertices give them. Only in scenes with textures, vertex colours or a picture as background.
#include "generated/instances.cl"
#include "kernels/core/load.cl"
#include "kernels/primitives/primitive.cl"
#include "kernels/textures/panorama.cl"
#include "kernels/textures/numbered.cl"

/// tints[i] belongs to ray live[first + i] and its hit, which is in instance instances[i] where scenes have some.
kernel void look_up_textures(SCENE_PARAMS, const global ushort *restrict scene_texels, LIVE_PARAMS, const global Ray *restrict rays,
                             const global Hit *restrict hits, const global uint *restrict instances, const global SurfacePoint *restrict points,
                             global Tints *restrict tints) {
    const Scene scene = SCENE_WITH_TEXELS;
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const Ray ray = rays[live[first + i]];
        const Hit hit = hits[i];
        Tints result = {{1.0f, 1.0f, 1.0f}, {1.0f, 1.0f, 1.0f}};
        if (hit.primitive == NO_HIT) {
            result.diffuse = color_of(scene, scene.header->background_texture, panorama_place(ray.direction, scene.header->background_turn));
        } else {
            const Ray inner = ray_in_group(scene, instance_at(instances, i), ray);
            const Pattern pattern = primitive_pattern(scene, SCENE_ARRAY(scene, ShadingRecord, shading)[hit.primitive], inner, hit);
            const global Material *material = SCENE_ARRAY(scene, Material, materials) + points[i].material;
            result.diffuse = times(pattern.color, color_of(scene, material->diffuse_texture, pattern.uv));
            result.specular = color_of(scene, material->specular_texture, pattern.uv);
        }
        tints[i] = result;
    }
}
