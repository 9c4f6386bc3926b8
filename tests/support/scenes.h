/// Small scenes, made in C++.
#pragma once
#include <map>
#include <random>
#include <string>

#include "scene/primitives/add.h"
#include "scene/scene.h"

namespace brandung {

/// Random numbers with a fixed seed.
class Random {
public:
    explicit Random(uint seed) : engine_(seed) {}
    float uniform(float low, float high) { return std::uniform_real_distribution(low, high)(engine_); }
    uint below(uint end) { return std::uniform_int_distribution(0u, end - 1)(engine_); }
    vec3 in_cube(float half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
    /// Unit length to rounding, uniform on the sphere.
    vec3 direction();

private:
    std::mt19937 engine_;
};

Material matte(float diffuse);
Material mirror(float reflection);
Material glass(float eta);
/// Shines, and does nothing else.
Material emitter(Spectrum radiance);
Light point_light(vec3 position, Spectrum intensity);
Light directional_light(vec3 towards, Spectrum irradiance);
/// `angle` is the cone's, from edge to edge [degrees].
Light spot_light(vec3 position, vec3 at, Spectrum intensity, double angle, double penumbra);

/// Adds a material and gives its index.
uint add_material(Scene &scene, const Material &material);
/// Has a matte material, number 0, and nothing else.
Scene empty_scene();
void add_triangle(Scene &scene, uint material, vec3 a, vec3 b, vec3 c);
/// Its shading normals are those of a sphere about `center`.
void add_smooth_triangle(Scene &scene, uint material, vec3 a, vec3 b, vec3 c, vec3 center);

/// Primitives in the cube [-1, 1]³, in random order.
struct Soup {
    uint of_each = 0;                         ///< so many of every kind in primitive_kinds()
    std::map<std::string, uint> counts = {};  ///< by kind, beside them
    float size = 0.1f;                        ///< of one primitive, at most
    uint seed = 1;
};
void add_soup(Scene &scene, uint material, const Soup &soup);

}  // namespace brandung
