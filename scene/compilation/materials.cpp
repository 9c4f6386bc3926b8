#include <algorithm>

#include "scene/bsdfs/bsdf.h"
#include "scene/bsdfs/choosing.h"
#include "scene/bsdfs/losses.h"
#include "scene/compilation/parts.h"
#include "scene/materials_in_use.h"

namespace brandung {
namespace {

bool has_eye_in(const Scene &scene, const std::string &material) {
    return std::any_of(scene.cameras.begin(), scene.cameras.end(), [&](const CameraDescription &camera) {
        return std::find(camera.inside.begin(), camera.inside.end(), material) != camera.inside.end();
    });
}

/// As kernels/integrators/bundle.cl says.
uint bundle_size(const Material &material, const Bundles &sizes) {
    const auto size = [&](uint flag, uint of_kind) { return (material.flags & flag) != 0 ? of_kind : 1; };
    return std::max({size(MATERIAL_DIFFUSE, sizes.diffuse), size(MATERIAL_GLOSSY, sizes.glossy), size(MATERIAL_PASSES, sizes.transmission)});
}

void count_media(const Scene &scene, const std::vector<bool> &used, CompiledScene &compiled) {
    if (!compiled.transmits) return;
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        const auto &[name, material, place] = scene.materials[m];
        compiled.media += (material.flags & MATERIAL_TRANSMITS) != 0 && (used[m] || has_eye_in(scene, name));
    }
    while (compiled.interior_size < std::min(compiled.media, max_interior_size)) compiled.interior_size = std::max(1u, 2 * compiled.interior_size);
}

void add_textures(const Scene &scene, const std::vector<Material> &used_materials, CompiledScene &compiled, Arena &arena) {
    std::vector<bool> used(scene.textures.size());
    const auto use = [&](uint number) {
        if (number > 0) used.at(number - 1) = true;
    };
    for (const Material &material : used_materials) use(material.diffuse_texture), use(material.specular_texture);
    compiled.texture_count = static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
    use(scene.background_texture);
    TexturePixels pixels = pixels_of(scene.textures, used);
    compiled.header.textures = arena.add(pixels.records);
    compiled.header.background_texture = scene.background_texture;
    compiled.header.background_turn = scene.background_turn;
    compiled.texels = std::move(pixels.texels);
    compiled.tints |= !compiled.texels.empty();
}

/// Gives those that let all light pass by chance the number of a material which does.
void add_passing_material(std::vector<Material> &materials, std::vector<Material> &used_materials) {
    if (std::none_of(used_materials.begin(), used_materials.end(), lets_light_pass)) return;
    for (Material &material : materials) fill_in_passing(material, uint(materials.size()));
    used_materials.push_back(materials.emplace_back(make_null(Spectrum(1))));
}

/// Those that choose have none.
std::vector<uint> kinds_of_bsdfs(std::vector<Material> used_materials) {
    std::erase_if(used_materials, chooses);
    return kinds_of(used_materials);
}

}  // namespace

void add_materials(const Scene &scene, const CompileOptions &options, CompiledScene &compiled, Arena &arena) {
    const std::vector<bool> used = materials_in_use(scene);
    const Bundles sizes = scene.integrator.bundles_in_use();
    std::vector<Material> materials, used_materials;
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        Material &material = materials.emplace_back(scene.materials[m].record);
        if (material.emission != Spectrum(0)) material.flags |= MATERIAL_SHINES;
        if (!used[m]) continue;
        used_materials.push_back(material);
        compiled.reflects |= (material.flags & MATERIAL_REFLECTS) != 0;
        compiled.transmits |= (material.flags & MATERIAL_TRANSMITS) != 0;
        compiled.chooses |= chooses(material);
        compiled.ideal |= (material.flags & MATERIAL_IDEAL) != 0 || lets_light_pass(material);
        compiled.losses |= (material.flags & MATERIAL_LOSES) != 0;
        compiled.facets |= material.flags / MATERIAL_FACETS & 3;
        compiled.highlights |= (material.flags & MATERIAL_HIGHLIGHT) != 0;
        compiled.bundle = std::max(compiled.bundle, bundle_size(material, sizes));
    }
    compiled.bundles = std::max(compiled.bundle, sizes.light) > 1;
    compiled.follows_one = !compiled.paths && compiled.transmits && scene.integrator.follows_one;
    count_media(scene, used, compiled);
    add_textures(scene, used_materials, compiled, arena);
    add_passing_material(materials, used_materials);
    compiled.bsdfs = kinds_of_bsdfs(used_materials);
    compiled.header.materials = arena.add(with_losses(materials, used, options.computes_losses), materials.size());
}

}  // namespace brandung
