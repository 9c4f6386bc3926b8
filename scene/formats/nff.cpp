/// Neutral File Format (E. Haines, 1988-1996, version 3.9), the format of the Standard Procedural Databases.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "scene/bsdfs/bsdf.h"
#include "scene/bsdfs/index_of_refraction.h"
#include "scene/formats/format.h"
#include "scene/formats/tokens.h"
#include "scene/lights/light.h"
#include "scene/parameters.h"
#include "scene/primitives/add.h"
#include "scene/view.h"
#include "scene/warnings.h"

namespace brandung {
namespace {

struct LightSource {
    vec3 position;
    Spectrum color;
};

/// What has been read so far.
struct Reading {
    explicit Reading(const std::string &file) : tokens(file) { scene.file = file; }
    /// Goes before the lines of objects.
    std::string before_lines() const { return scene.file + ":"; }

    Tokens tokens;
    Scene scene;
    uint viewpoint_line = 0;           ///< 0: none yet
    std::vector<LightSource> sources;  ///< how bright they are depends on their number
    MeshData mesh;                     ///< consecutive polygons of one kind and material
    uint materials = 0;                ///< the file's own
};

/// A material from the columns of an `f` line: Ks and T weigh the secondary rays as they stand, without Fresnel's reflectance.
void add_material(Reading &reading, const std::string &name, Spectrum color, float kd, float ks, float shine, float t, float eta) {
    const Whitted whitted = {.ambient = color * kd,
                             .diffuse = color * kd,
                             .specular = Spectrum(ks),
                             .reflection = Spectrum(ks),
                             .transmission = Spectrum(t),
                             .exponent = shine,
                             .fresnel = 0};
    Material material = make_material(whitted);
    // Rules 8 and 9 of the databases: no ray is too weak to be traced, and what transmits reflects too.
    if (ks > 0 || t > 0) material.flags |= MATERIAL_REFLECTS | MATERIAL_SPAWNS_ALWAYS;
    if (t > 0) material.flags |= MATERIAL_TRANSMITS;
    material.eta = eta;
    reading.scene.materials.push_back({name, material, fmt::format("{}:{}", reading.scene.file, reading.tokens.line())});
}

/// Ends the run of polygons, so that primitives stay in the order of the file.
void finish_mesh(Reading &reading) {
    const uint material = uint(reading.scene.materials.size() - 1);
    if (!reading.mesh.indices.empty()) add_triangle_mesh(reading.scene, material, std::move(reading.mesh), reading.before_lines());
    reading.mesh = {};
}

/// The material of the object that follows: the last one.
uint object_material(Reading &reading) {
    if (reading.scene.materials.empty()) add_material(reading, "default", Spectrum(0.5f), 1, 0, 1, 0, 1);
    if (reading.materials == 0) ++reading.scene.warnings["object before any material: grey"];
    return uint(reading.scene.materials.size() - 1);
}

void read_resolution(Tokens &tokens, FilmSettings &film) {
    for (uint *size : {&film.width, &film.height}) {
        const int64 pixels = tokens.integer("resolution");
        if (pixels < 1 || pixels > 65535) tokens.fail(fmt::format("resolution: must be from 1 to 65535, got {}", pixels));
        *size = uint(pixels);
    }
}

float read_angle(Tokens &tokens) {
    const float degrees = tokens.number("angle");
    if (!(degrees > 0 && degrees < 180)) tokens.fail(fmt::format("angle: must be above 0 and below 180 degrees, got {:g}", degrees));
    return glm::radians(degrees);
}

/// The lines of a viewpoint, in any order; "hither" may be missing, since rays begin at the eye.
void read_viewpoint(Reading &reading) {
    Tokens &tokens = reading.tokens;
    if (reading.viewpoint_line != 0) tokens.fail(fmt::format("second viewpoint; the first is on line {}", reading.viewpoint_line));
    reading.viewpoint_line = tokens.line();
    CameraDescription camera;
    camera.name = "camera";
    const char *const names[] = {"from", "at", "up", "angle", "resolution", "hither"};
    bool seen[std::size(names)] = {};
    while (true) {
        const auto name = std::find(std::begin(names), std::end(names), tokens.peek());
        if (name == std::end(names)) break;
        tokens.word();
        const std::size_t i = std::size_t(name - names);
        if (seen[i]) tokens.fail(fmt::format("viewpoint: second \"{}\"", *name));
        seen[i] = true;
        if (i < 3) (i == 0 ? camera.from : i == 1 ? camera.at : camera.up) = tokens.vector(*name);
        if (i == 3) camera.fov = read_angle(tokens);
        if (i == 4) read_resolution(tokens, reading.scene.film);
        if (i == 5) tokens.number(*name);
    }
    for (std::size_t i = 0; i < 5; ++i) {
        if (!seen[i]) tokens.fail_at(reading.viewpoint_line, fmt::format("viewpoint: needs \"{}\", found {}", names[i], tokens.found()));
    }
    if (const auto fault = view_fault(camera)) tokens.fail_at(reading.viewpoint_line, fmt::format("viewpoint: \"{}\" {}", fault->key, fault->why));
    reading.scene.cameras.push_back(camera);
}

void read_background(Reading &reading) { reading.scene.background = reading.tokens.color("background"); }

void read_light(Reading &reading) {
    Tokens &tokens = reading.tokens;
    const vec3 position = tokens.vector("light");
    reading.sources.push_back({position, tokens.at_number_on_line() ? tokens.color("color of a light") : Spectrum(1)});
}

void read_fill(Reading &reading) {
    Tokens &tokens = reading.tokens;
    finish_mesh(reading);
    const uint line = tokens.line();
    const Spectrum color = tokens.color("color of a material");
    const float kd = tokens.not_negative("Kd of a material"), ks = tokens.not_negative("Ks of a material");
    const float shine = tokens.not_negative("shine of a material"), t = tokens.not_negative("T of a material");
    const float eta = tokens.not_negative("index of refraction");
    if (t > 0 && eta == 0) tokens.fail("index of refraction: must be positive where T is, got 0");
    if (t > 0 && !is_permitted_index(eta)) tokens.fail("index of refraction: " + why_no_index(eta));
    add_material(reading, fmt::format("line {}", line), color, kd, ks, shine, t, is_permitted_index(eta) ? eta : 1);
    ++reading.materials;
}

void read_cone(Reading &reading) {
    Tokens &tokens = reading.tokens;
    finish_mesh(reading);
    const vec3 base = tokens.vector("base of a cone");
    const float base_radius = tokens.length("base radius of a cone");
    const vec3 apex = tokens.vector("apex of a cone");
    const float apex_radius = tokens.length("apex radius of a cone");
    if ((base_radius < 0 && apex_radius > 0) || (base_radius > 0 && apex_radius < 0))
        tokens.fail(fmt::format("cone: radii must have the same sign, got {:g} and {:g}", base_radius, apex_radius));
    add_frustum(reading.scene, object_material(reading), base, base_radius, apex, apex_radius);
}

void read_ball(Reading &reading) {
    finish_mesh(reading);
    const vec3 center = reading.tokens.vector("center of a sphere");
    const float radius = reading.tokens.length("radius of a sphere");
    add_sphere(reading.scene, object_material(reading), center, radius);
}

/// Vertices, each followed by its normal where `normals` is given; a patch with a normal of length 0 gets none.
void read_vertices(Reading &reading, std::vector<vec3> &vertices, std::vector<vec3> *normals) {
    Tokens &tokens = reading.tokens;
    const uint line = tokens.line();
    const int64 count = tokens.integer("number of vertices");
    if (count < 3) tokens.fail(fmt::format("polygon: needs at least 3 vertices, got {}", count));
    bool smooth = true;
    for (int64 i = 0; i < count; ++i) {
        if (!tokens.at_number())
            tokens.fail(fmt::format("polygon of line {}: expected {} vertices, found {} and {}", line, count, i, tokens.found()));
        vertices.push_back(tokens.vector("vertex of a polygon"));
        if (!normals) continue;
        const float x = tokens.number("normal of a patch"), y = tokens.number("normal of a patch"), z = tokens.number("normal of a patch");
        const glm::dvec3 normal(x, y, z);
        smooth = smooth && normal != glm::dvec3(0);
        normals->push_back(vec3(glm::normalize(normal)));
    }
    if (!smooth) {
        normals->clear();
        ++reading.scene.warnings["patch with a normal of length 0: flat"];
    }
}

void add_polygon(Reading &reading, const std::vector<vec3> &vertices, const std::vector<vec3> &normals) {
    if (reading.mesh.normals.empty() != normals.empty()) finish_mesh(reading);
    object_material(reading);
    append_polygon(reading.scene, reading.mesh, vertices, normals);
}

void read_flat_polygon(Reading &reading) {
    std::vector<vec3> vertices;
    read_vertices(reading, vertices, nullptr);
    add_polygon(reading, vertices, {});
}

void read_patch(Reading &reading) {
    std::vector<vec3> vertices, normals;
    read_vertices(reading, vertices, &normals);
    add_polygon(reading, vertices, normals);
}

struct Entity {
    std::string_view name;
    void (*read)(Reading &reading);
};
constexpr Entity entities[] = {{"s", read_ball}, {"p", read_flat_polygon}, {"pp", read_patch},     {"c", read_cone},
                               {"f", read_fill}, {"l", read_light},        {"b", read_background}, {"v", read_viewpoint}};

/// Where the scene keeps places: that of what has been added on this line, to the mesh that is not finished or as shapes of their own.
void keep_place(Reading &reading, uint line) {
    Scene &scene = reading.scene;
    if (!scene.places) return;
    reading.mesh.numbers.resize(reading.mesh.indices.size() / 3, line);
    if (!scene.shapes.empty()) scene.places->try_emplace(scene.shapes.back().get(), PlaceInFile{reading.before_lines(), {line}});
}

void read_entities(Reading &reading) {
    while (!reading.tokens.at_end()) {
        const std::string_view name = reading.tokens.word();
        const auto entity = std::find_if(std::begin(entities), std::end(entities), [&](const Entity &e) { return e.name == name; });
        if (entity == std::end(entities)) reading.tokens.fail("expected one of v, b, l, f, c, s, p, pp, found " + quoted(name));
        const uint line = reading.tokens.line();
        entity->read(reading);
        keep_place(reading, line);
        place_warnings(reading.scene, [&] { return fmt::format("{}:{}", reading.scene.file, line); });
    }
    finish_mesh(reading);
    if (reading.viewpoint_line == 0) reading.tokens.fail("the file has no viewpoint (v)");
}

/// NFF leaves brightness open. Each of n lights has 1 / sqrt(n), at any distance; the factor pi is that of a diffuse surface.
void add_lights(Reading &reading) {
    const float intensity = float(std::numbers::pi / std::sqrt(double(reading.sources.size())));
    for (const LightSource &source : reading.sources) {
        const PointLight light = {.position = source.position, .intensity = source.color * intensity, .attenuation = {1, 0, 0}};
        reading.scene.lights.push_back(make_light(light));
    }
}

}  // namespace

Scene read_nff(const std::string &file, const ReadOptions &options) {
    Reading reading(file);
    if (options.keep_places) reading.scene.places.emplace();
    read_entities(reading);
    add_lights(reading);
    assign_settings(options.assignments, reading.scene);
    return std::move(reading.scene);
}

}  // namespace brandung
