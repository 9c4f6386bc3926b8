/// Files of meshes as objects of scene files.
#include <filesystem>

#include "scene/error.h"
#include "scene/meshes/mesh_file.h"
#include "scene/parameters.h"
#include "scene/primitives/add.h"
#include "scene/primitives/kinds.h"

namespace brandung {
namespace {

std::string file_beside(const Scene &scene, const Parameters &parameters, const std::string &name) {
    const std::string file = (std::filesystem::path(scene.file).parent_path() / name).string();
    try {
        check_mesh_file(file);
    } catch (const SceneError &error) {
        parameters.fail("file", error.what());
    }
    return file;
}

}  // namespace

/// The file's materials are named "FILE:NAME" in the scene, as the scene spells the file.
void read_mesh(const Parameters &parameters, uint material, Scene &scene) {
    const std::string name = parameters.text("file"), file = file_beside(scene, parameters, name);
    scene.files.push_back(file);
    const bool own = material == material_of_file;
    const std::string before = before_numbers(file);
    for (MeshPart &part : read_mesh_file(file, own ? MaterialPrefix(name + ":") : std::nullopt, scene, parameters.progress()))
        add_triangle_mesh(scene, own ? part.material : material, std::move(part.mesh), before);
}

}  // namespace brandung
