#include "tests/support/primitives.h"

#include <map>
#include <stdexcept>

namespace brandung {
namespace {

void add_any_sphere(Scene &scene, uint material, Random &, vec3 place, float size) { add_sphere(scene, material, place, size); }

void add_any_triangle(Scene &scene, uint material, Random &random, vec3 place, float size) {
    const vec3 a = place + random.in_cube(size), b = place + random.in_cube(size), c = place + random.in_cube(size);
    add_triangle(scene, material, a, b, c);
}

void add_any_smooth_triangle(Scene &scene, uint material, Random &random, vec3 place, float size) {
    const vec3 a = place + random.in_cube(size), b = place + random.in_cube(size), c = place + random.in_cube(size);
    add_smooth_triangle(scene, material, a, b, c, place);
}

void add_any_frustum(Scene &scene, uint material, Random &random, vec3 place, float size) {
    const vec3 base = place + random.in_cube(size), apex = place + random.in_cube(size);
    const float base_radius = random.uniform(0, 0.5f) * size, apex_radius = random.uniform(0, 0.5f) * size;
    add_frustum(scene, material, base, base_radius, apex, apex_radius);
}

void add_any_disk(Scene &scene, uint material, Random &random, vec3 place, float size) {
    add_disk(scene, material, place, random.direction(), random.uniform(0.1f, 1) * size);
}

/// By the kind's name. A new kind is added here.
const std::map<std::string, AddPrimitive> makers = {
    {"sphere", add_any_sphere},   {"triangle", add_any_triangle}, {"smooth_triangle", add_any_smooth_triangle},
    {"frustum", add_any_frustum}, {"disk", add_any_disk},
};

}  // namespace

AddPrimitive maker_of(const std::string &kind) {
    const auto maker = makers.find(kind);
    if (maker == makers.end()) throw std::out_of_range("tests/support/primitives.cpp has no maker of '" + kind + "'");
    return maker->second;
}

std::vector<std::string> names_of_primitive_kinds() {
    std::vector<std::string> names;
    for (const PrimitiveKind *kind : primitive_kinds()) names.emplace_back(kind->name);
    return names;
}

}  // namespace brandung
