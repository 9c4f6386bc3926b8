/// Files that hold nothing but meshes.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "scene/formats/format.h"
#include "scene/scene.h"

namespace brandung {

/// Triangles with one material.
struct MeshPart {
    uint material;  ///< index into Scene::materials, if materials are read
    MeshData mesh;  ///< with numbers of lines or faces, if the scene keeps places
};
/// What goes before the numbers of a file's meshes.
std::string before_numbers(const std::string &file);

/// What stands before the names of a file's materials in the scene; without it materials, their libraries and textures are not read.
using MaterialPrefix = std::optional<std::string>;

/// What a file has, in its order. Materials go to the scene, those of which it has one of that name being taken as they are. Throws SceneError
/// `file:line: why`; what is left out is a counted warning of the scene.
std::vector<MeshPart> read_obj(const std::string &file, const MaterialPrefix &prefix, Scene &scene, const ReadProgress &progress);
std::vector<MeshPart> read_ply(const std::string &file, const MaterialPrefix &prefix, Scene &scene, const ReadProgress &progress);

/// One of the two, by the file's extension. Throws SceneError, as check_mesh_file does before anything is read.
std::vector<MeshPart> read_mesh_file(const std::string &file, const MaterialPrefix &prefix, Scene &scene, const ReadProgress &progress);
/// Throws SceneError if the file cannot be read, or its extension is none of the two.
void check_mesh_file(const std::string &file);

/// The number in the scene of the material of this name; it is added if there is none yet.
uint add_material(Scene &scene, const NamedMaterial &material);

}  // namespace brandung
