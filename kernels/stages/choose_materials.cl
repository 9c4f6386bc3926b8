// From hits to materials. Only in scenes where some choose among others.
#include "generated/interior.cl"
#include "kernels/bsdfs/choice.h"
#include "kernels/core/load.cl"
#include "kernels/core/random.cl"
#include "kernels/primitives/placed.cl"
#include "kernels/textures/numbered.cl"

#define CHOICES 0x63686f69u  ///< keeps these random numbers apart from others of the same ray

/// Of the second member at a hit.
FUNCTION float chance_of_second(Scene scene, Choice choice, uint texture, Ray ray, PlacedHit hit) {
    Spectrum amount = choice.amount;
    if (texture != 0u) {
        const Ray inner = ray_in_group(scene, place_of(hit), ray);
        const Pattern pattern = primitive_pattern(scene, SCENE_ARRAY(scene, ShadingRecord, shading)[hit.hit.primitive], inner, hit.hit);
        amount = times(amount, color_of(scene, texture, pattern.uv));
    }
    return (amount.x + amount.y + amount.z) / 3.0f;
}

/// Which of both members material `number`, which chooses, stands for where a ray with this branch has its hit.
FUNCTION uint member_at(Scene scene, uint number, Ray ray, uint branch, PlacedHit hit) {
    const global Material *material = SCENE_ARRAY(scene, Material, materials) + number;
    const Choice choice = *(const global Choice *)material->words;
    const float random = unit_interval(hash(branch ^ hash(number + CHOICES)));
    const bool second = choice.by_side != 0u ? dot3(surface_of(scene, ray, hit).geometric, ray.direction) >= 0.0f
                                             : random < chance_of_second(scene, choice, material->diffuse_texture, ray, hit);
    return choice.members[second ? 1 : 0];
}

/// chosen[i] is the material of hits[i] of ray live[first + i], a function of the way that the ray has come; 0 after a miss. etas[i], where scenes
/// have transparent materials, becomes the ratio of indices with it.
kernel void choose_materials(SCENE_PARAMS, const global Texel *restrict scene_texels, LIVE_PARAMS, const global Ray *restrict rays,
                             const global Path *restrict paths, const global Hit *restrict hits, const global uint *restrict instances,
                             global float *restrict etas, global uint *restrict chosen) {
    const Scene scene = SCENE_WITH_TEXELS;
    const global Material *materials = SCENE_ARRAY(scene, Material, materials);
    FOR_EACH_ITEM_SERIALLY(i, count) {
        const uint k = live[first + i];
        const PlacedHit hit = placed(hits[i], instance_at(instances, i));
        chosen[i] = 0u;
        if (hit.hit.primitive == NO_HIT) continue;
        uint number = material_index_of(scene, hit);
        const bool chooses = (materials[number].flags & MATERIAL_CHOOSES) != 0u;
        while ((materials[number].flags & MATERIAL_CHOOSES) != 0u) number = member_at(scene, number, rays[k], paths[k].branch, hit);
        if (chooses) store_eta_of_chosen(etas, i, materials + number);
        chosen[i] = number;
    }
}
