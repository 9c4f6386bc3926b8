/// What the two lists are made of.
#pragma once
#include "scene/primitives/shape.h"

namespace brandung {

extern const PrimitiveKind sphere_kind, triangle_kind, smooth_triangle_kind, frustum_kind, disk_kind;

void read_sphere(const Parameters &parameters, uint material, Scene &scene);
void read_disk(const Parameters &parameters, uint material, Scene &scene);
void read_frustum(const Parameters &parameters, uint material, Scene &scene);
void read_cylinder(const Parameters &parameters, uint material, Scene &scene);
void read_triangle_mesh(const Parameters &parameters, uint material, Scene &scene);
void read_mesh(const Parameters &parameters, uint material, Scene &scene);
void read_polygon(const Parameters &parameters, uint material, Scene &scene);

/// One vector per vertex, scaled to unit length; empty if absent. Throws SceneError if they are not as many or have no length.
std::vector<vec3> read_normals(const Parameters &parameters, const std::string &name, std::size_t vertices);
/// "uvs": one pair per vertex; empty if absent. Throws SceneError if they are not as many.
std::vector<vec2> read_uvs(const Parameters &parameters, std::size_t vertices);

}  // namespace brandung
