/// Wavefront OBJ: polygons, their groups and materials.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>

#include "scene/formats/tokens.h"
#include "scene/meshes/mesh_builder.h"
#include "scene/meshes/mesh_file.h"
#include "scene/meshes/mtl.h"
#include "scene/textures/texture.h"
#include "scene/tone.h"
#include "scene/warnings.h"

namespace brandung {
namespace {

namespace fs = std::filesystem;

constexpr uint lines_between_reports = 1u << 14;

/// A name that faces have been given.
struct UsedMaterial {
    uint number;  ///< in the order of first uses
    uint line;    ///< of the first
};

/// What has been read so far. Faces name vertices by number, so that what they name is kept whole.
struct Reading {
    Reading(const std::string &file, const MaterialPrefix &prefix, Scene &scene) : file(file), prefix(prefix), tokens(file), scene(scene) {}

    const std::string &file;
    const MaterialPrefix &prefix;
    Tokens tokens;
    Scene &scene;
    MeshTables tables;
    MeshBuilder builder{tables};
    std::string group, object;
    std::map<std::string, UsedMaterial> materials;  ///< by name
    std::map<std::string, MtlMaterial> mtl_materials;
    std::vector<MeshVertex> corners;  ///< of a face
};

void warn(Reading &reading, const std::string &text) { ++reading.scene.warnings[text]; }

/// From the curve of sRGB; what is not from 0 to 1 is taken as the nearest that is, and counted.
Spectrum linear_color(Reading &reading, const float *encoded) {
    Spectrum color;
    bool cut = false;
    for (int c = 0; c < 3; ++c) {
        const float inside = std::fmin(std::fmax(encoded[c], 0.0f), 1.0f);
        cut |= inside != encoded[c];
        color[c] = srgb_decoded(inside);
    }
    if (cut) warn(reading, "vertex whose colour is not from 0 to 1: cut");
    return color;
}

/// A vertex `x y z`, `x y z w` or `x y z r g b`; colours are sRGB, as programs write them that paint meshes.
void read_vertex(Reading &reading) {
    Tokens &tokens = reading.tokens;
    float values[7];
    uint count = 0;
    while (count < std::size(values) && !tokens.at_line_end()) values[count++] = tokens.any_length("coordinate of a vertex");
    if (count < 3) tokens.fail(fmt::format("vertex: expected 3 coordinates, found {}", count));
    MeshTables &tables = reading.tables;
    tables.positions.push_back({values[0], values[1], values[2]});
    const uint color = count >= 6 ? count - 3 : 0;
    if (color == 0 && tables.colors.empty()) return;
    if (tables.colors.empty()) tables.colors.resize(tables.positions.size() - 1, Spectrum(1));
    tables.colors.push_back(color == 0 ? Spectrum(1) : linear_color(reading, values + color));
}

void read_normal(Reading &reading) {
    Tokens &tokens = reading.tokens;
    const auto part = [&] {
        if (tokens.at_line_end()) tokens.fail("normal: expected 3 numbers on the line");
        return tokens.any_length("normal");
    };
    const float x = part(), y = part(), z = part();
    reading.tables.add_normal({x, y, z});
}

/// One to three coordinates, of which two are used.
void read_uv(Reading &reading) {
    Tokens &tokens = reading.tokens;
    float values[3] = {};
    uint count = 0;
    while (count < std::size(values) && !tokens.at_line_end()) values[count++] = tokens.any_length("texture coordinate");
    if (count == 0) tokens.fail("texture coordinates: expected 1 to 3 numbers on the line");
    reading.tables.uvs.emplace_back(values[0], values[1]);
}

/// The place of what an index names, counted from 1, or backwards from the last one read; none if there is no such thing.
uint place_of(int64 index, std::size_t count) {
    const int64 place = index > 0 ? index - 1 : int64(count) + index;
    return index != 0 && place >= 0 && place < int64(count) ? uint(place) : MeshVertex::none;
}

/// A corner of a face: `v`, `v/vt`, `v//vn` or `v/vt/vn`. Tells whether it names something beside its vertex that is not there.
MeshVertex read_corner(Reading &reading, std::string_view word, bool &lacks_uv, bool &lacks_normal) {
    int64 indices[3] = {};
    bool given[3] = {};
    const char *at = word.data(), *const end = at + word.size();
    for (int i = 0; i < 3 && at != end; ++i) {
        const auto [stop, error] = std::from_chars(at, end, indices[i]);
        given[i] = error == std::errc();
        if ((!given[i] && i == 0) || (stop != end && *stop != '/'))
            reading.tokens.fail("face: expected v, v/vt, v//vn or v/vt/vn, found " + quoted(word));
        at = stop == end || i == 2 ? stop : stop + 1;
    }
    if (at != end) reading.tokens.fail("face: expected v, v/vt, v//vn or v/vt/vn, found " + quoted(word));
    const MeshTables &tables = reading.tables;
    MeshVertex vertex{.position = place_of(indices[0], tables.positions.size())};
    if (vertex.position == MeshVertex::none)
        reading.tokens.fail(fmt::format("face: there is no vertex {}; the file has {} so far", indices[0], tables.positions.size()));
    if (!tables.colors.empty()) vertex.color = vertex.position;
    if (given[1]) vertex.uv = place_of(indices[1], tables.uvs.size());
    if (given[2]) vertex.normal = place_of(indices[2], tables.normals.size());
    lacks_uv |= given[1] && vertex.uv == MeshVertex::none, lacks_normal |= given[2] && vertex.normal == MeshVertex::none;
    return vertex;
}

void read_face(Reading &reading) {
    if (reading.scene.places) reading.builder.set_number(reading.tokens.line());
    bool lacks_uv = false, lacks_normal = false;
    reading.corners.clear();
    while (!reading.tokens.at_line_end()) reading.corners.push_back(read_corner(reading, reading.tokens.word(), lacks_uv, lacks_normal));
    if (lacks_uv) warn(reading, "face with texture coordinates that the file does not have: without");
    if (lacks_normal) warn(reading, "face with a normal that the file does not have: without");
    reading.builder.add_face(reading.corners, reading.scene.warnings);
}

void read_group(Reading &reading) {
    std::string name = reading.tokens.rest_of_line();
    if (name == reading.group) return;
    reading.group = std::move(name);
    reading.builder.start_part();
}

void read_object(Reading &reading) {
    std::string name = reading.tokens.rest_of_line();
    if (name == reading.object) return;
    reading.object = std::move(name);
    reading.builder.start_part();
}

void read_smoothing(Reading &reading) {
    const std::string_view word = reading.tokens.word_on_line();
    uint group = 0;
    if (word != "off") {
        const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), group);
        if (error != std::errc() || stop != word.data() + word.size())
            reading.tokens.fail("smoothing group: expected a number or off, found " + quoted(word));
    }
    reading.builder.set_smoothing(group);
}

void read_material(Reading &reading) {
    const UsedMaterial next{uint(reading.materials.size()), reading.tokens.line()};
    const auto known = reading.materials.emplace(reading.tokens.rest_of_line(), next).first;
    reading.builder.set_material(known->second.number);
}

/// Names of libraries, with a backslash before each of their blanks, or none before those of a single one.
std::vector<std::string> library_names(const std::string &line, const fs::path &folder) {
    std::error_code error;
    if (fs::is_regular_file(folder / line, error)) return {line};
    std::vector<std::string> names(1);
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool blank = line[i] == ' ' || line[i] == '\t';
        if (line[i] == '\\' && i + 1 < line.size() && line[i + 1] == ' ')
            names.back() += line[++i];
        else if (!blank)
            names.back() += line[i];
        else if (!names.back().empty())
            names.emplace_back();
    }
    return names;
}

void read_library(Reading &reading) {
    if (!reading.prefix) return reading.tokens.skip_line();
    const uint line = reading.tokens.line();
    const fs::path folder = fs::path(reading.file).parent_path();
    for (const std::string &name : library_names(reading.tokens.rest_of_line(), folder)) {
        const fs::path path = folder / name;
        std::error_code error;
        if (name.empty() || !fs::is_regular_file(path, error)) {
            warn(reading, "material library " + brandung::quoted(name) + " is not there");
            continue;
        }
        place_warnings(reading.scene, [&] { return fmt::format("{}:{}", reading.file, line); });
        reading.scene.files.push_back(path.string());
        // Of several materials of one name the first counts.
        for (MtlMaterial &material : read_mtl(path.string(), reading.scene)) reading.mtl_materials.emplace(material.name, std::move(material));
    }
}

struct Statement {
    std::string_view name;
    void (*read)(Reading &reading);
};
constexpr Statement statements[] = {{"v", read_vertex},       {"f", read_face},   {"vn", read_normal},   {"vt", read_uv},
                                    {"g", read_group},        {"o", read_object}, {"s", read_smoothing}, {"usemtl", read_material},
                                    {"mtllib", read_library}, {"fo", read_face}};

/// Statements that leave a picture as it is: they concern other programs, or are about things that have warnings of their own.
constexpr std::string_view without_effect[] = {"vw",       "vp",         "mg",        "lod",    "bevel", "c_interp",
                                               "d_interp", "shadow_obj", "trace_obj", "usemap", "maplib"};
constexpr std::string_view free_forms[] = {"curv", "curv2", "surf", "cstype", "deg", "bmat", "step", "parm", "trim",  "hole", "scrv",
                                           "sp",   "end",   "con",  "bzp",    "bsp", "cdc",  "cdp",  "res",  "ctech", "stech"};

template <class List> bool has(const List &list, std::string_view word) {
    return std::find(std::begin(list), std::end(list), word) != std::end(list);
}

void leave_out(Reading &reading, std::string_view name) {
    if (name == "p")
        warn(reading, "points (p): left out");
    else if (name == "l")
        warn(reading, "lines (l): left out");
    else if (has(free_forms, name))
        warn(reading, "free-form curves and surfaces: left out");
    else if (!has(without_effect, name))
        warn(reading, "unknown statement: left out");
    reading.tokens.skip_line();
}

void read_statement(Reading &reading, std::string_view name) {
    const auto statement = std::find_if(std::begin(statements), std::end(statements), [&](const Statement &s) { return s.name == name; });
    if (statement == std::end(statements)) return leave_out(reading, name);
    statement->read(reading);
    if (reading.tokens.at_line_end()) return;
    warn(reading, "statement with more on its line than it takes: the rest is left out");
    reading.tokens.skip_line();
}

void read_statements(Reading &reading, const ReadProgress &progress) {
    Tokens &tokens = reading.tokens;
    for (uint lines = 0; !tokens.at_end(); ++lines) {
        if (progress && lines % lines_between_reports == 0) progress(reading.file, tokens.part());
        const std::string_view name = tokens.word();
        const uint line = tokens.line();
        read_statement(reading, name);
        place_warnings(reading.scene, [&] { return fmt::format("{}:{}", reading.file, line); });
    }
}

/// The library's material of that name, which may be followed by a comment; null if there is none.
const MtlMaterial *find_material(const std::map<std::string, MtlMaterial> &library, const std::string &name) {
    const std::string before_comment = name.substr(0, name.find_last_not_of(" \t", name.find('#') - 1) + 1);
    for (const std::string &wanted : {name, before_comment})
        if (const auto found = library.find(wanted); found != library.end()) return &found->second;
    return nullptr;
}

/// As Material has it; `library` is the file that names it. Files that were written on Windows have backslashes between folders.
uint texture(Scene &scene, const fs::path &library, const MtlTexture &texture) {
    std::string name = texture.file;
    std::replace(name.begin(), name.end(), '\\', '/');
    if (name.empty()) return 0;
    return add_texture(scene, (library.parent_path() / name).string(), {texture.clamps ? TextureWrap::clamp : TextureWrap::repeat, texture.encoding});
}

/// Of a material's textures the one by which its meshes' texture coordinates are changed: they have one set of them.
const MtlTexture &placing_texture(const MtlMaterial &material) { return material.map_kd.file.empty() ? material.map_ks : material.map_kd; }

void place_textures(const MtlTexture &texture, std::vector<vec2> &uvs) {
    if (texture.is_placed_as({})) return;
    for (vec2 &uv : uvs) uv = texture.scale * uv + texture.offset;
}

/// The scene's number of a material of a library.
uint library_material(const Reading &reading, const std::string &name, const MtlMaterial &mtl) {
    Scene &scene = reading.scene;
    if (!mtl.map_ks.file.empty() && !mtl.map_ks.is_placed_as(placing_texture(mtl)))
        ++scene.warnings["material whose textures have different scales or offsets: those of map_Kd count"];
    Material material = make_material(mtl, scene.warnings);
    material.diffuse_texture = texture(scene, mtl.file, mtl.map_kd);
    material.specular_texture = texture(scene, mtl.file, mtl.map_ks);
    const std::string place = fmt::format("{}:{}", mtl.file, mtl.line);
    place_warnings(scene, [&] { return place; });
    return add_material(scene, {*reading.prefix + name, material, place});
}

/// The scene's number of a material that is named, but not in any library.
uint missing_material(const Reading &reading, const std::string &name, uint line) {
    const std::string place = fmt::format("{}:{}", reading.file, line);
    ++reading.scene.warnings["material that no library has: taken as grey"];
    place_warnings(reading.scene, [&] { return place; });
    return add_material(reading.scene, {*reading.prefix + name, default_mesh_material(!reading.tables.colors.empty()), place});
}

/// Gives parts, whose materials are the reader's, those of the scene.
void set_materials(const Reading &reading, std::vector<MeshPart> &parts) {
    std::vector<std::pair<std::string, uint>> uses(reading.materials.size());
    for (const auto &[name, use] : reading.materials) uses[use.number] = {name, use.line};
    std::map<uint, uint> known;
    for (MeshPart &part : parts) {
        if (part.material == MeshBuilder::no_material) {
            const Material plain = default_mesh_material(!reading.tables.colors.empty());
            part.material = add_material(reading.scene, {*reading.prefix + "no material", plain, reading.file});
            continue;
        }
        const auto &[name, line] = uses[part.material];
        const MtlMaterial *found = find_material(reading.mtl_materials, name);
        if (found) place_textures(placing_texture(*found), part.mesh.uvs);
        const auto [entry, added] = known.emplace(part.material, 0);
        if (added) entry->second = found ? library_material(reading, name, *found) : missing_material(reading, name, line);
        part.material = entry->second;
    }
}

}  // namespace

std::vector<MeshPart> read_obj(const std::string &file, const MaterialPrefix &prefix, Scene &scene, const ReadProgress &progress) {
    Reading reading(file, prefix, scene);
    read_statements(reading, progress);
    std::vector<MeshPart> parts = reading.builder.finish();
    if (prefix) set_materials(reading, parts);
    place_warnings(scene, [&] { return file; });
    return parts;
}

}  // namespace brandung
