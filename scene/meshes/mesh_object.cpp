/// Files of meshes as objects of scene files.
#include <filesystem>

#include "scene/error.h"
#include "scene/meshes/mesh_file.h"
#include "scene/parameters.h"
#include "scene/primitives/add.h"
#include "scene/primitives/kinds.h"

namespace brandung {
namespace {

std::string readable_file(const Parameters &parameters, const Scene &scene, const std::string &name) {
    const std::string file = (std::filesystem::path(scene.file).parent_path() / name).string();
    try {
        check_readable(file);
    } catch (const SceneError &error) {
        parameters.fail("file", error.what());
    }
    return file;
}

}  // namespace

/// The file's materials are named "FILE:NAME" in the scene, as the scene spells the file.
void read_mesh(const Parameters &parameters, uint material, Scene &scene) {
    const std::string name = parameters.text("file"), file = readable_file(parameters, scene, name);
    const bool own = material == material_of_file;
    Scene unused;  // gets materials that the scene doesn't need
    if (scene.places) unused.places.emplace();
    for (MeshPart &part : read_mesh_file(file, name + ":", own ? scene : unused, parameters.progress()))
        add_triangle_mesh(scene, own ? part.material : material, std::move(part.mesh), before_numbers(file));
    for (const auto &[text, count] : unused.warnings) scene.warnings[text] += count;
}

}  // namespace brandung
