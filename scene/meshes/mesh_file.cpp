#include "scene/meshes/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "scene/error.h"
#include "scene/input.h"
#include "scene/meshes/default_view.h"
#include "scene/primitives/add.h"

namespace brandung {
namespace {

using ReadParts = std::vector<MeshPart> (*)(const std::string &file, const std::string &prefix, Scene &scene, const ReadProgress &progress);

/// A file of meshes as a scene: what else a scene needs is chosen for it.
Scene read_as_scene(const std::string &file, const ReadOptions &options, ReadParts read) {
    Scene scene;
    scene.file = file;
    if (options.keep_places) scene.places.emplace();
    assign_settings(options.assignments, scene);
    std::vector<MeshPart> parts = read(file, "", scene, options.progress);
    add_default_view(parts, options.view, scene);
    for (MeshPart &part : parts) add_triangle_mesh(scene, part.material, std::move(part.mesh), before_numbers(file));
    return scene;
}

std::string extension_of(const std::string &file) {
    std::string extension = std::filesystem::path(file).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
    return extension;
}

}  // namespace

Scene read_obj_scene(const std::string &file, const ReadOptions &options) { return read_as_scene(file, options, read_obj); }
Scene read_ply_scene(const std::string &file, const ReadOptions &options) { return read_as_scene(file, options, read_ply); }

/// Lines of text can be looked up, bytes have none.
std::string before_numbers(const std::string &file) { return extension_of(file) == ".ply" ? file + ": face " : file + ":"; }

std::vector<MeshPart> read_mesh_file(const std::string &file, const std::string &prefix, Scene &scene, const ReadProgress &progress) {
    check_readable(file);
    const std::string extension = extension_of(file);
    if (extension == ".obj") return read_obj(file, prefix, scene, progress);
    if (extension == ".ply") return read_ply(file, prefix, scene, progress);
    throw SceneError(file + ": unknown format of meshes \"" + extension + "\"; known by extension: .obj .ply");
}

uint add_material(Scene &scene, const std::string &name, const Material &material) {
    const auto same_name = [&](const NamedMaterial &known) { return known.name == name; };
    const auto known = std::find_if(scene.materials.begin(), scene.materials.end(), same_name);
    const uint number = uint(known - scene.materials.begin());
    if (known == scene.materials.end()) scene.materials.push_back({name, material});
    return number;
}

}  // namespace brandung
