#include "scene/meshes/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "scene/error.h"
#include "scene/input.h"
#include "scene/meshes/default_view.h"
#include "scene/primitives/add.h"
#include "scene/warnings.h"

namespace brandung {
namespace {

using ReadParts = std::vector<MeshPart> (*)(const std::string &file, const MaterialPrefix &prefix, Scene &scene, const ReadProgress &progress);

/// Why a file has nothing that can be seen.
std::string why_nothing(const Scene &scene) {
    std::string why;
    for (const auto &[text, count] : scene.warnings) why += fmt::format("{}{} ({})", why.empty() ? "; " : ", ", text, count);
    return why;
}

/// Refuses a file without triangles, and one for which no camera can be found though none was asked for.
void check_view(const Scene &scene, const ViewChanges &changes) {
    if (scene.shapes.empty()) throw SceneError(scene.file + ": has no faces with an area, so that nothing of it can be seen" + why_nothing(scene));
    if (!changes.from && !changes.at && scene.cameras[0].from == scene.cameras[0].at)
        throw SceneError(scene.file + ": is so small and so far from the origin that floats have no place for a camera beside it; --from gives one");
}

/// A file of meshes as a scene: what else a scene needs is chosen for it.
Scene read_as_scene(const std::string &file, const ReadOptions &options, ReadParts read) {
    Scene scene;
    scene.file = file;
    if (options.keep_places) scene.places.emplace();
    set_default_quality(scene);
    scene.integrator.shadows_unsaid = true;
    assign_settings(options.assignments, scene);
    std::vector<MeshPart> parts = read(file, "", scene, options.progress);
    add_default_view(parts, options.view, scene);
    const std::string before = before_numbers(file);
    for (MeshPart &part : parts) add_triangle_mesh(scene, part.material, std::move(part.mesh), before);
    check_view(scene, options.view);
    place_warnings(scene, [&] { return file; });
    return scene;
}

/// The reader of files with this extension. Throws SceneError if there is none.
ReadParts reader_of(const std::string &file) {
    std::string extension = std::filesystem::path(file).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
    if (extension == ".obj") return read_obj;
    if (extension == ".ply") return read_ply;
    throw SceneError(file + ": unknown format of meshes \"" + extension + "\"; known by extension: .obj .ply");
}

}  // namespace

Scene read_obj_scene(const std::string &file, const ReadOptions &options) { return read_as_scene(file, options, read_obj); }
Scene read_ply_scene(const std::string &file, const ReadOptions &options) { return read_as_scene(file, options, read_ply); }

/// Lines of text can be looked up, bytes have none.
std::string before_numbers(const std::string &file) { return reader_of(file) == read_ply ? file + ": face " : file + ":"; }

void check_mesh_file(const std::string &file) {
    check_readable(file);
    reader_of(file);
}

std::vector<MeshPart> read_mesh_file(const std::string &file, const MaterialPrefix &prefix, Scene &scene, const ReadProgress &progress) {
    return reader_of(file)(file, prefix, scene, progress);
}

uint add_material(Scene &scene, const NamedMaterial &material) {
    const auto same_name = [&](const NamedMaterial &known) { return known.name == material.name; };
    const auto known = std::find_if(scene.materials.begin(), scene.materials.end(), same_name);
    const uint number = uint(known - scene.materials.begin());
    if (known == scene.materials.end()) scene.materials.push_back(material);
    return number;
}

}  // namespace brandung
