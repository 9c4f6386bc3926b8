#include "tests/support/scenes.h"

#include <algorithm>

#include "scene/bsdfs/bsdf.h"
#include "scene/lights/light.h"
#include "tests/support/primitives.h"

namespace brandung {

vec3 Random::direction() {
    for (;;) {
        const glm::dvec3 p(in_cube(1));
        const double length = glm::length(p);
        if (length > 0.1 && length <= 1) return vec3(p / length);
    }
}

Material matte(float diffuse) { return make_material(Whitted{.ambient = Spectrum(diffuse), .diffuse = Spectrum(diffuse), .exponent = 1}); }

Material mirror(float reflection) { return make_material(Whitted{.reflection = Spectrum(reflection), .exponent = 1}); }

Material glass(float eta) {
    Material material = make_material(Whitted{.reflection = Spectrum(1), .transmission = Spectrum(1), .exponent = 1, .fresnel = 1});
    material.eta = eta;
    return material;
}

Material emitter(Spectrum radiance) {
    Material material = make_material(Whitted{.exponent = 1});
    material.emission = radiance;
    return material;
}

Light point_light(vec3 position, Spectrum intensity) { return make_light(PointLight{position, intensity, vec3(0, 0, 1)}); }

Light directional_light(vec3 towards, Spectrum irradiance) {
    return make_light(DirectionalLight{vec3(glm::normalize(glm::dvec3(towards))), irradiance});
}

Light spot_light(vec3 position, vec3 at, Spectrum intensity, double angle, double penumbra) {
    SpotLight light{position, vec3(glm::normalize(glm::dvec3(at) - glm::dvec3(position))), intensity, vec3(0, 0, 1), 0, 0};
    shape_cone(light, glm::radians(angle), penumbra);
    return make_light(light);
}

uint add_material(Scene &scene, const Material &material) {
    scene.materials.push_back({std::to_string(scene.materials.size()), material});
    return uint(scene.materials.size() - 1);
}

Scene empty_scene() {
    Scene scene;
    add_material(scene, matte(0.5f));
    return scene;
}

void add_triangle(Scene &scene, uint material, vec3 a, vec3 b, vec3 c) {
    add_triangle_mesh(scene, material, MeshData{.positions = {a, b, c}, .indices = {0, 1, 2}});
}

void add_smooth_triangle(Scene &scene, uint material, vec3 a, vec3 b, vec3 c, vec3 center) {
    const auto normal = [&](vec3 p) { return vec3(glm::normalize(glm::dvec3(p) - glm::dvec3(center))); };
    add_triangle_mesh(scene, material, MeshData{.positions = {a, b, c}, .normals = {normal(a), normal(b), normal(c)}, .indices = {0, 1, 2}});
}

void add_soup(Scene &scene, uint material, const Soup &soup) {
    Random random(soup.seed);
    std::vector<AddPrimitive> order;
    for (const std::string &kind : names_of_primitive_kinds()) order.insert(order.end(), soup.of_each, maker_of(kind));
    for (const auto &[kind, count] : soup.counts) order.insert(order.end(), count, maker_of(kind));
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(uint(i))]);
    for (const AddPrimitive add : order) {
        const vec3 place = random.in_cube(1);
        add(scene, material, random, place, soup.size * random.uniform(0.1f, 1));
    }
}

}  // namespace brandung
