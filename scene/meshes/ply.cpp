/// PLY, as text and as bytes of both orders.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "scene/error.h"
#include "scene/input.h"
#include "scene/meshes/mesh_builder.h"
#include "scene/meshes/mtl.h"
#include "scene/meshes/ply_values.h"
#include "scene/textures/texture.h"
#include "scene/tone.h"
#include "scene/warnings.h"

namespace brandung {

void PlyBytes::fail(const std::string &why) const { throw SceneError(fmt::format("{}: byte {}: {}", file_, at_ - text_.data(), why)); }

namespace {

constexpr uint64 elements_between_reports = 1u << 16;

/// What a property of a vertex or a face is.
enum Role { x, y, z, nx, ny, nz, red, green, blue, u, v, roles, other = roles };

struct RoleName {
    std::string_view name;
    Role role;
};
constexpr RoleName role_names[] = {{"x", x},
                                   {"y", y},
                                   {"z", z},
                                   {"nx", nx},
                                   {"ny", ny},
                                   {"nz", nz},
                                   {"red", red},
                                   {"green", green},
                                   {"blue", blue},
                                   {"r", red},
                                   {"g", green},
                                   {"b", blue},
                                   {"u", u},
                                   {"v", v},
                                   {"s", u},
                                   {"t", v},
                                   {"texture_u", u},
                                   {"texture_v", v},
                                   {"texture_s", u},
                                   {"texture_t", v},
                                   {"diffuse_red", red},
                                   {"diffuse_green", green},
                                   {"diffuse_blue", blue}};

Role role_of(const PlyProperty &property) {
    const auto found = std::find_if(std::begin(role_names), std::end(role_names), [&](const RoleName &r) { return r.name == property.name; });
    return property.count || found == std::end(role_names) ? other : found->role;
}

std::vector<Role> roles_of(const PlyElement &element) {
    std::vector<Role> result(element.properties.size());
    std::transform(element.properties.begin(), element.properties.end(), result.begin(), role_of);
    return result;
}

bool has_all(const std::vector<Role> &given, std::initializer_list<Role> wanted) {
    return std::all_of(wanted.begin(), wanted.end(), [&](Role role) { return std::find(given.begin(), given.end(), role) != given.end(); });
}

bool is_index_list(const PlyProperty &property) { return property.count && (property.name == "vertex_indices" || property.name == "vertex_index"); }
bool is_uv_list(const PlyProperty &property) { return property.count && property.name == "texcoord"; }

/// Colours of whole numbers are sRGB and reach to the largest of their type, others are linear.
float linear_color(double value, PlyType type) {
    if (is_float(type)) return std::isfinite(value) ? float(std::max(value, 0.0)) : 0;
    const double largest = std::exp2(8 * bytes_of(type) - is_signed(type)) - 1;
    return srgb_decoded(float(std::clamp(value / largest, 0.0, 1.0)));
}

/// Reads elements from `Values`, which is PlyText or PlyBytes.
template <class Values> class PlyReader {
public:
    PlyReader(const std::string &file, Values &values, Scene &scene, const ReadProgress &progress)
        : file_(file), values_(values), scene_(scene), progress_(progress) {}

    std::vector<MeshPart> read(const PlyHeader &header) {
        const auto is_face = [](const PlyElement &element) { return element.name == "face" || element.name == "tristrips"; };
        for (const PlyElement &element : header.elements) {
            if (element.properties.empty()) continue;
            expect_enough(element);
            if (element.name == "vertex")
                read_vertices(element);
            else if (is_face(element))
                read_faces(element);
            else
                skip(element);
        }
        if (values_.has_more()) ++scene_.warnings["data behind the last element: left out"];
        if (std::none_of(header.elements.begin(), header.elements.end(), is_face)) ++scene_.warnings["points without faces: left out"];
        return builder_.finish();
    }

private:
    /// Refuses counts that the file cannot have, before memory is taken for them.
    void expect_enough(const PlyElement &element) const {
        std::size_t bytes = 0;
        for (const PlyProperty &property : element.properties) bytes += Values::smallest(property.count.value_or(property.type));
        if (element.count > values_.left() / bytes)
            values_.fail(fmt::format("the header promises {} of element {}, but only {} bytes are left", element.count,
                                     brandung::quoted(element.name), values_.left()));
    }

    void report(uint64 i) const {
        if (progress_ && i % elements_between_reports == 0) progress_(file_, values_.part());
    }

    uint64 list_length(const PlyProperty &property) {
        const double length = values_.value(*property.count, "length of a list");
        if (length < 0 || length > double(values_.left() / Values::smallest(property.type)))
            values_.fail(fmt::format("a list of {} values, but only {} bytes are left", length, values_.left()));
        return uint64(length);
    }

    void skip(const PlyProperty &property) {
        const uint64 count = property.count ? list_length(property) : 1;
        for (uint64 i = 0; i < count; ++i) values_.value(property.type, property.name.c_str());
    }

    void skip(const PlyElement &element) {
        for (uint64 i = 0; i < element.count; ++i) {
            report(i);
            for (const PlyProperty &property : element.properties) skip(property);
        }
    }

    void read_vertices(const PlyElement &element) {
        const std::vector<Role> at = roles_of(element);
        if (!has_all(at, {x, y, z})) values_.fail("element \"vertex\" has not all of the properties x, y and z");
        normals_ = has_all(at, {nx, ny, nz}), uvs_ = has_all(at, {u, v}), colors_ = has_all(at, {red, green, blue});
        tables_.positions.reserve(element.count);
        std::array<double, roles + 1> value{};
        for (uint64 i = 0; i < element.count; ++i) {
            report(i);
            for (std::size_t p = 0; p < at.size(); ++p) {
                if (at[p] == other) {
                    skip(element.properties[p]);
                    continue;
                }
                const PlyType type = element.properties[p].type;
                value[at[p]] = values_.value(type, "property of a vertex");
                if (at[p] >= red && at[p] <= blue) value[at[p]] = linear_color(value[at[p]], type);
            }
            tables_.positions.emplace_back(value[x], value[y], value[z]);
            if (normals_) tables_.add_normal({value[nx], value[ny], value[nz]});
            if (colors_) tables_.colors.emplace_back(value[red], value[green], value[blue]);
            if (uvs_) tables_.uvs.emplace_back(value[u], value[v]);
        }
        vertices_ = element.count;
        if (vertices_ >= MeshVertex::none) values_.fail("more vertices than can be numbered");
    }

    void read_faces(const PlyElement &element) {
        if (std::none_of(element.properties.begin(), element.properties.end(), is_index_list))
            values_.fail("element " + brandung::quoted(element.name) + " has no list vertex_indices");
        const std::vector<Role> at = roles_of(element);
        const bool colored = has_all(at, {red, green, blue});
        for (uint64 i = 0; i < element.count; ++i) {
            report(i);
            uv_list_.clear();
            for (std::size_t p = 0; p < at.size(); ++p) read_face_property(element.properties[p], at[p]);
            if (scene_.places) builder_.set_number(faces_);
            ++faces_;
            if (element.name == "face")
                add_face(colored);
            else
                add_strips();
        }
    }

    void read_face_property(const PlyProperty &property, Role role) {
        if (is_index_list(property))
            read_list(property, indices_);
        else if (is_uv_list(property))
            read_list(property, uv_list_);
        else if (role >= red && role <= blue)
            face_color_[role - red] = linear_color(values_.value(property.type, "colour of a face"), property.type);
        else
            skip(property);
    }

    void read_list(const PlyProperty &property, std::vector<double> &list) {
        list.resize(list_length(property));
        for (double &value : list) value = values_.value(property.type, "value of a list");
    }

    MeshVertex vertex(double index) const {
        if (!(index >= 0 && index < double(vertices_) && index == std::floor(index)))
            values_.fail(fmt::format("face: there is no vertex {}; {} have been read", index, vertices_));
        const uint place = uint(index);
        const auto own = [&](bool has) { return has ? place : MeshVertex::none; };
        return {.position = place, .uv = own(uvs_), .normal = own(normals_), .color = own(colors_)};
    }

    /// The place of the face's colour, which those that follow one another share.
    uint color_place() {
        if (tables_.colors.empty() || tables_.colors.back() != face_color_) tables_.colors.push_back(face_color_);
        return uint(tables_.colors.size() - 1);
    }

    /// Texture coordinates of the face itself, two per corner, and its colour go before those of its vertices.
    void add_face(bool colored) {
        corners_.clear();
        for (const double index : indices_) corners_.push_back(vertex(index));
        if (!uv_list_.empty() && uv_list_.size() == 2 * corners_.size()) {
            for (std::size_t i = 0; i < corners_.size(); ++i) {
                corners_[i].uv = uint(tables_.uvs.size());
                tables_.uvs.emplace_back(uv_list_[2 * i], uv_list_[2 * i + 1]);
            }
        }
        if (colored)
            for (MeshVertex &corner : corners_) corner.color = color_place();
        builder_.add_face(corners_, scene_.warnings);
    }

    /// Every index after the second of a strip ends a triangle; they turn about in turns. A negative one ends the strip.
    void add_strips() {
        std::size_t begin = 0;
        for (std::size_t i = 0; i < indices_.size(); ++i) {
            if (indices_[i] < 0) begin = i + 1;
            if (i < begin + 2 || indices_[i] < 0) continue;
            const bool turned = (i - begin) % 2 != 0;
            corners_ = {vertex(indices_[i - (turned ? 1 : 2)]), vertex(indices_[i - (turned ? 2 : 1)]), vertex(indices_[i])};
            builder_.add_face(corners_, scene_.warnings);
        }
    }

    const std::string &file_;
    Values &values_;
    Scene &scene_;
    const ReadProgress &progress_;
    MeshTables tables_;
    MeshBuilder builder_{tables_};
    uint64 vertices_ = 0;
    uint faces_ = 0;                                       ///< so far, and strips
    bool normals_ = false, uvs_ = false, colors_ = false;  ///< whether vertices have them
    std::vector<double> indices_, uv_list_;
    Spectrum face_color_{0};
    std::vector<MeshVertex> corners_;
};

/// The texture that a comment names, as MeshLab writes it; empty without one.
std::string texture_file(const PlyHeader &header) {
    constexpr std::string_view key = "comment TextureFile ";
    for (const std::string &comment : header.comments) {
        if (comment.starts_with(key)) return comment.substr(key.size(), comment.find_last_not_of(" \t\r") + 1 - key.size());
    }
    return "";
}

template <class Values>
std::vector<MeshPart> read_with(const std::string &file, std::string text, const PlyHeader &header, Scene &scene, const ReadProgress &progress) {
    Values values(file, std::move(text), header);
    return PlyReader<Values>(file, values, scene, progress).read(header);
}

}  // namespace

std::vector<MeshPart> read_ply(const std::string &file, const MaterialPrefix &prefix, Scene &scene, const ReadProgress &progress) {
    std::string text = file_text(file);
    const PlyHeader header = read_ply_header(file, text);
    const auto read = header.format == PlyFormat::ascii ? read_with<PlyText> : read_with<PlyBytes>;
    std::vector<MeshPart> parts = read(file, std::move(text), header, scene, progress);
    place_warnings(scene, [&] { return file; });
    if (!prefix) return parts;
    const bool colors = std::any_of(parts.begin(), parts.end(), [](const MeshPart &part) { return !part.mesh.colors.empty(); });
    const std::string texture = texture_file(header);
    Material material = default_mesh_material(colors || !texture.empty());
    if (!texture.empty()) material.diffuse_texture = add_texture(scene, (std::filesystem::path(file).parent_path() / texture).string());
    const uint number = add_material(scene, {*prefix + "no material", material, file});
    for (MeshPart &part : parts) part.material = number;
    return parts;
}

}  // namespace brandung
