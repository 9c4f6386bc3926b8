/// Shape: something of a scene that rays can meet.
#pragma once
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "kernels/core/scene.h"
#include "kernels/lights/emission.h"
#include "kernels/primitives/smooth_triangle.h"
#include "scene/bounds.h"
#include "scene/primitives/hull.h"

namespace brandung {

class Parameters;
struct Scene;

/// A kind of primitive that the kernels know: `kernels/primitives/<name>.h` declares <record>Block and <record>Shading.
struct PrimitiveKind {
    const char *name;         ///< "smooth_triangle": prefix of its device functions
    const char *record;       ///< "SmoothTriangle": prefix of its records
    std::size_t block_bytes;  ///< of one block of BLOCK_SIZE primitives
    bool is_flat;             ///< rays cross it once at most, and not again after leaving it
    bool has_vertices;        ///< Hit.u, v are the weights of the second and the third one
    std::size_t table_bytes;  ///< that each has at least in SharedTables
};

/// Tables of the arena that shapes append to while the scene is laid out.
struct SharedTables {
    std::vector<VertexNormals> vertex_normals;
    std::vector<VertexUvs> vertex_uvs;
    std::vector<VertexColors> vertex_colors;
    bool wants_uvs = false;    ///< whether the material of the shape at hand has a texture
    std::size_t lack_uvs = 0;  ///< triangles that would have needed them
};

/// Stands for the number of an object where the file does not number any.
inline constexpr uint NO_OBJECT = 0xffffffffu;

class Shape;
/// Where shapes are in files whose objects have no numbers, for those who ask.
struct PlaceInFile {
    std::string before;         ///< "bunny.obj:" or "bunny.ply: face "
    std::vector<uint> numbers;  ///< that follow it: one per primitive
};
using ShapePlaces = std::map<const Shape *, PlaceInFile>;

/// One or more primitives of one kind with one material.
class Shape {
public:
    explicit Shape(uint material) : material(material) {}
    virtual ~Shape() = default;

    virtual const PrimitiveKind &kind() const = 0;
    virtual std::size_t count() const { return 1; }
    /// A box around primitive i that contains the one which the kernels derive from its block.
    virtual Bounds bounds(std::size_t i) const = 0;
    /// Holds primitive i, and but for a pad (kernels/core/lane_ray.cl) the line of every ray that the kernels find to hit it; the box where nothing
    /// smaller does.
    virtual Hull hull(std::size_t i) const = 0;
    /// Writes primitive i, without its number, to lane `lane` of a block of block_bytes.
    virtual void write_lane(std::size_t i, uint lane, std::byte *block) const = 0;
    /// Writes primitive i's view of ShadingRecord.words (at most 56 bytes).
    virtual void write_shading(std::size_t i, uint *words, SharedTables &tables) const = 0;

    /// The shape as a light of radiance 1, which both of its sides have, in cells * cells parts that count the same; its faces, if it has some to
    /// choose from, are appended.
    virtual std::vector<Light> light(uint cells, std::vector<EmissiveFace> &faces) const = 0;

    /// The same for what chooses among lights: each of its flat faces is one, of radiance 1. None where it is not made of flat faces.
    virtual std::vector<Light> flat_lights() const { return {}; }

    uint material;            ///< index into Scene::materials
    uint object = NO_OBJECT;  ///< its number among the objects of the scene file, or of the file's group
};

/// Stands for materials that a file of meshes has of its own.
inline constexpr uint material_of_file = 0xffffffffu;

/// A shape's name in scene files and how it is read; adds its shapes to the scene.
struct ShapeReader {
    const char *name;
    void (*read)(const Parameters &parameters, uint material, Scene &scene);
    bool from_file = false;  ///< whether scenes need not name its material, which is then material_of_file
};
/// All shapes that scene files may name.
const std::vector<ShapeReader> &shape_readers();
/// All kinds of primitives, in the order in which generated lists name them.
const std::vector<const PrimitiveKind *> &primitive_kinds();

// One maker per kind; null where the thing has no surface. scene/primitives/add.h counts these.
std::unique_ptr<Shape> make_sphere(uint material, vec3 center, float radius);
/// `normal`, not 0, leads to the outside; both sides are visible.
std::unique_ptr<Shape> make_disk(uint material, vec3 center, vec3 normal, float radius);
/// From base to apex, without caps; both radii negative: only the inside is visible.
std::unique_ptr<Shape> make_frustum(uint material, vec3 base, float base_radius, vec3 apex, float apex_radius);

/// Vertices shared by triangles; `normals` (unit length), `uvs` and `colors` (factors of the diffuse reflectance) are empty or as many as
/// `positions`.
struct MeshData {
    std::vector<vec3> positions, normals;
    std::vector<vec2> uvs;
    std::vector<Spectrum> colors;
    std::vector<uint> indices;  ///< three per triangle
    std::vector<uint> numbers;  ///< of lines or faces of its file: one per triangle, or none, see ShapePlaces
};
std::unique_ptr<Shape> make_triangle_mesh(uint material, MeshData mesh);
/// Whether the kernels can tell the triangle's normal. They too round the edges to float, and then make no error that matters.
bool has_area(vec3 a, vec3 b, vec3 c);
/// Indices (three per triangle) of a triangulation of a simple, possibly concave, nearly planar polygon; empty if it has no area.
std::vector<uint> triangulate(const std::vector<vec3> &polygon);

}  // namespace brandung
