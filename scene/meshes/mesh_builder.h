/// MeshBuilder: from faces whose corners name positions, normals and texture coordinates each by a number of its own to meshes whose vertices have
/// all of them.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/meshes/mesh_file.h"
#include "scene/meshes/place_table.h"

namespace brandung {

/// What faces name by number, counted from 0. A reader appends to it while it reads.
struct MeshTables {
    std::vector<vec3> positions;   ///< not finite where the file has no usable one
    std::vector<vec3> normals;     ///< of unit length, or 0 where the file has no usable one
    std::vector<vec2> uvs;         ///< not finite where the file has no usable ones
    std::vector<Spectrum> colors;  ///< linear

    void add_normal(vec3 normal);
};

/// A corner of a face.
struct MeshVertex {
    static constexpr uint none = 0xffffffffu;
    uint position, uv = none, normal = none, color = none;

    bool operator==(const MeshVertex &) const = default;
};

class MeshBuilder {
public:
    static constexpr uint no_material = 0xffffffffu;

    /// `tables` may grow from face to face.
    explicit MeshBuilder(const MeshTables &tables) : tables_(tables) {}

    /// What follows belongs to another group than what has been added.
    void start_part() { part_is_open_ = false; }
    /// Of the faces that follow: a number of the reader's.
    void set_material(uint material);
    /// Of the faces that follow: those of one group share normals where they have none of their own; 0: they stay flat.
    void set_smoothing(uint group) { smoothing_ = group; }
    /// Of the face that follows, in its file; all faces have one, or none has.
    void set_number(uint number) { number_ = number; }
    /// Adds a polygon, perhaps concave. What cannot be used is left out and counted.
    void add_face(const std::vector<MeshVertex> &corners, std::map<std::string, uint> &warnings);
    /// The meshes, of one material and group each, in the order of their first faces. Ends the builder.
    std::vector<MeshPart> finish();

private:
    /// Where the vertices of a part get their normals from.
    enum class Normals { none, own, smoothed };
    /// The sum of a smoothing group's normals at a position.
    struct SmoothNormal {
        glm::dvec3 sum;
        uint position, group;
    };
    /// A part whose normals are known when all faces are.
    struct SmoothPart {
        std::size_t part;
        std::vector<uint> normals;  ///< by vertex: place in smooth_normals_
    };

    Normals normals_of(const std::vector<MeshVertex> &corners, std::map<std::string, uint> &warnings) const;
    bool has_uvs(const std::vector<MeshVertex> &corners) const;
    void open_part(Normals normals, bool uvs, bool colors);
    uint local(const MeshVertex &vertex);
    uint smooth_normal(uint position);
    void smooth(std::vector<MeshVertex> &corners);
    void fill_normals(const SmoothPart &smooth);

    const MeshTables &tables_;
    std::vector<MeshPart> parts_;
    uint material_ = no_material, smoothing_ = 0;
    std::optional<uint> number_;
    bool part_is_open_ = false;  ///< the last part goes on
    bool uvs_ = false, colors_ = false;
    Normals normals_ = Normals::none;  ///< of the last part, as what it has
    std::vector<MeshVertex> locals_;   ///< vertices of the last part
    PlaceTable local_places_;          ///< of locals_
    std::vector<SmoothNormal> smooth_normals_;
    PlaceTable smooth_places_;  ///< of smooth_normals_
    std::vector<SmoothPart> smooth_parts_;
    std::vector<MeshVertex> corners_;  // of the face that is added
    std::vector<vec3> polygon_;
    std::vector<uint> vertices_;
};

}  // namespace brandung
