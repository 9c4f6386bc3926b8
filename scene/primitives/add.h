/// Adding shapes to a scene, the same for every format: what has no surface becomes a counted warning.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace brandung {

/// A negative radius: only the inside is visible.
void add_sphere(Scene &scene, uint material, vec3 center, float radius);
/// `normal`, of any length but 0, leads to the outside.
void add_disk(Scene &scene, uint material, vec3 center, vec3 normal, float radius);
/// The lateral surface between two circles; both radii negative: only the inside is visible. One may be 0, but they have not both signs.
void add_frustum(Scene &scene, uint material, vec3 base, float base_radius, vec3 apex, float apex_radius);
/// Makes shapes a group, and gives its index.
uint add_group(Scene &scene, std::string name, std::vector<std::unique_ptr<Shape>> shapes);
/// Places a group; of `material`, unless that is NO_MATERIAL. Gives why that cannot be, if so.
std::optional<std::string> add_instance(Scene &scene, uint group, const AffineMap &map, uint material = NO_MATERIAL);
/// The same of one that moves while the scene's shutter is open.
std::optional<std::string> add_instance(Scene &scene, uint group, const Motion &motion, uint material = NO_MATERIAL);
/// Indices are below the number of positions; `before` goes before the mesh's numbers, if the scene keeps places.
void add_triangle_mesh(Scene &scene, uint material, MeshData mesh, const std::string &before = {});
/// Indices (three per triangle) of a polygon's triangles; empty without area. What is wrong with it is counted.
std::vector<uint> triangulate_polygon(const std::vector<vec3> &vertices, std::map<std::string, uint> &warnings);
/// Triangulates a polygon and appends it to a mesh; `normals` is empty, as in the mesh so far, or has a unit vector per vertex.
void append_polygon(Scene &scene, MeshData &mesh, const std::vector<vec3> &vertices, const std::vector<vec3> &normals);

}  // namespace brandung
