/// kernels/lights/choice.cl: directions in which paths ask for light are as dense as what paths meet by chance takes them to be.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "scene/compile.h"
#include "scene/primitives/add.h"
#include "tests/support/probe.h"
#include "tests/support/scenes.h"
#include "tests/support/statistics/chi_square.h"
#include "tests/support/statistics/means.h"
#include "tests/support/statistics/significance.h"
#include "tests/support/traced_scene.h"

namespace brandung {
namespace {

constexpr uint asked = 1 << 18;           ///< directions
constexpr uint rings = 16, sectors = 32;  ///< of the sphere of directions, of equal solid angle
constexpr uint steps = 40;                ///< by which each is divided in both ways, to add its density up
constexpr uint regular = rings * sectors * steps * steps;

/// Light at a point: rays to what is asked, with t_max < 0 where nothing comes from; and how dense they should be about what rays meet.
class LightAt {
public:
    LightAt(Scene scene, vec3 p) : traced_(compile(scene)), p_(p) {}

    /// What is asked, and with what density [1/sr].
    struct Asked {
        std::vector<Ray> rays;
        std::vector<vec3> directions;  ///< of the points themselves: rays to them end a little off
        std::vector<float> densities;
        std::vector<float> irradiances;  ///< red, over the chance of the light
    };
    Asked ask() {
        Kernel kernel = kernel_of("ask", R"(
        kernel void ask(SCENE_PARAMS, const global Texel *scene_texels, uint count, float x, float y, float z, global Ray *rays,
                        global vec3 *directions, global float *densities, global float *irradiances) {
            const Scene scene = SCENE_WITH_TEXELS;
            const uint i = get_global_id(0);
            if (i >= count) return;
            const vec3 p = make3(x, y, z);
            vec2 square;
            square.x = unit_interval(hash(5u * i)), square.y = unit_interval(hash(5u * i + 1u));
            const ChosenLight chosen = light_chosen(scene, p, unit_interval(hash(5u * i + 2u)), hash(5u * i + 4u));
            const Light light = SCENE_ARRAY(scene, Light, lights)[chosen.row];
            const LightSample sample = light_sample(scene, light, p, light_random(square, hash(5u * i + 3u)));
            rays[i] = ray_to_light(p, sample.ray_direction, sample.distance, NO_HIT);
            if (!(largest(sample.irradiance) > 0.0f)) rays[i].t_max = -1.0f;
            directions[i] = sample.direction;
            densities[i] = 1.0f / inverse_light_density(chosen, sample);
            irradiances[i] = sample.irradiance.x * chosen.inverse_chance;
        })");
        const Buffer<Ray> rays(test_device(), kernel.work_items(asked));
        const Buffer<vec3> directions(test_device(), kernel.work_items(asked));
        const Buffer<float> densities(test_device(), kernel.work_items(asked)), irradiances(test_device(), kernel.work_items(asked));
        kernel(asked, traced_.on_device(), traced_.on_device().texels(), asked, p_.x, p_.y, p_.z, rays, directions, densities, irradiances);
        return {rays.read(0, asked), directions.read(0, asked), densities.read(0, asked), irradiances.read(0, asked)};
    }

    /// What rays meet first: its density (x) and red radiance (y).
    std::vector<vec2> met(const std::vector<Ray> &rays) {
        const std::vector<Hit> hits = traced_.closest_hits(rays);
        Kernel kernel = kernel_of("met", R"(
#include "kernels/lights/environment.cl"
        kernel void met(SCENE_PARAMS, const global Texel *scene_texels, uint count, const global Ray *rays, const global Hit *hits,
                        const global uint *instances, global vec2 *results) {
            const Scene scene = SCENE_WITH_TEXELS;
            const uint i = get_global_id(0);
            if (i >= count) return;
            const Ray ray = rays[i];
            if (hits[i].primitive == NO_HIT) {
                results[i].x = environment_density(scene, ray.direction), results[i].y = environment_radiance(scene, ray.direction).x;
                return;
            }
            const uint instance = instance_at(instances, i);
            const ShadingRecord record = SCENE_ARRAY(scene, ShadingRecord, shading)[hits[i].primitive];
            const Surface surface = surface_in_world(scene, instance, primitive_surface(scene, record, ray_in_group(scene, instance, ray), hits[i]));
            const global Material *material = SCENE_ARRAY(scene, Material, materials) + record.material;
            const float cosine = dot3(surface.geometric, ray.direction);
            const Spectrum radiance = emitted(material, cosine > 0.0f ? SURFACE_BACK : 0u);
            const vec3 straight = minus(surface.p, ray.origin);
            results[i].x = emission_density(scene, record, instance, radiance, ray.origin, surface.p, surface.geometric,
                                            sqrt(dot3(straight, straight)), cosine);
            results[i].y = radiance.x;
        })");
        const Buffer<Ray> ray_buffer(test_device(), rays);
        const Buffer<Hit> hit_buffer(test_device(), hits);
        std::vector<uint> instances = traced_.instances();
        instances.resize(rays.size());
        const Buffer<uint> instance_buffer(test_device(), instances);
        const Buffer<vec2> results(test_device(), kernel.work_items(rays.size()));
        kernel(rays.size(), traced_.on_device(), traced_.on_device().texels(), uint(rays.size()), ray_buffer, hit_buffer, instance_buffer, results);
        return results.read(0, rays.size());
    }

    std::vector<std::uint8_t> visible(const std::vector<Ray> &rays) { return traced_.visible(traced_.traversals().back(), rays); }

private:
    Kernel kernel_of(const char *name, const std::string &text) {
        Sources sources = traced_.on_device().lists();
        const std::string file = std::string(name) + ".cl";
        sources[file] = R"(#include "generated/instances.cl"
#include "kernels/bsdfs/emitted.cl"
#include "kernels/core/random.cl"
#include "kernels/core/scene.cl"
#include "kernels/core/spawn.cl"
#include "kernels/lights/choice.cl"
#include "kernels/lights/light.cl")" +
                        text;
        return Kernel(test_device(), file, name, sources, 1);
    }

    TracedScene traced_;
    vec3 p_;
};

uint cell_of(vec3 direction) {
    const double turns = std::atan2(double(direction.y), double(direction.x)) / (2 * std::numbers::pi);
    const uint ring = std::min(uint(std::max((double(direction.z) + 1) / 2 * rings, 0.0)), rings - 1);
    return ring * sectors + std::min(uint((turns - std::floor(turns)) * sectors), sectors - 1);
}

/// Evenly over all cells, steps * steps in each.
std::vector<Ray> regular_rays(vec3 p) {
    std::vector<Ray> rays;
    for (uint i = 0; i < rings * steps; ++i)
        for (uint j = 0; j < sectors * steps; ++j) {
            const double z = 2 * (i + 0.5) / (rings * steps) - 1, angle = 2 * std::numbers::pi * (j + 0.5) / (sectors * steps),
                         r = std::sqrt(1 - z * z);
            rays.push_back(make_ray(p, vec3(r * std::cos(angle), r * std::sin(angle), z)));
        }
    return rays;
}

struct Lit {
    const char *name;
    std::function<void(Scene &scene)> add;
};

/// All but half of the sphere of directions from (0, 0, 0) is free.
const std::vector<Lit> all_lit = {
    {"Quad",
     [](Scene &scene) {
         MeshData mesh;
         append_polygon(scene, mesh, {{-1, -0.5f, 1}, {1, -0.5f, 1.5f}, {1, 1, 1.5f}, {-1, 1, 1}}, {});
         add_triangle_mesh(scene, 1, std::move(mesh));
     }},
    {"Mesh",
     [](Scene &scene) {
         add_triangle_mesh(
             scene, 1, {.positions = {{-1, -1, 1}, {2, -1, 1}, {2, 2, 2}, {-1, 1, 1}, {0.1f, 0.05f, 0.7f}}, .indices = {0, 1, 4, 4, 1, 2, 4, 2, 3}});
     }},
    {"SphereAround",
     [](Scene &scene) {
         add_sphere(scene, 1, {0.5f, 0.4f, 0.3f}, 1.5f);
     }},
    {"Cone",
     [](Scene &scene) {
         add_frustum(scene, 1, {0, 0, 1}, 1, {0.5f, 1, 1.5f}, 0.2f);
     }},
    {"Disk",
     [](Scene &scene) {
         add_disk(scene, 1, {0.2f, 0.3f, 1}, {0.3f, -0.2f, -1}, 1.2f);
     }},
    {"StretchedDisk",
     [](Scene &scene) {
         add_disk(scene, 1, {0, 0, 0}, {0.5f, 0, 1}, 1.5f);
         const uint group = add_group(scene, "lamp", std::exchange(scene.shapes, {}));
         ASSERT_FALSE(
             add_instance(scene, group, then(scaling({-0.5, 1, 0.6}), then(rotation(40, {1, 2, 3}), translation({0.3, 0, 1}))), NO_MATERIAL));
     }},
    {"StretchedTriangle",
     [](Scene &scene) {
         add_triangle(scene, 1, {-1, -1, 0.5f}, {1, -1, 0}, {0, 1, 0});
         const uint group = add_group(scene, "lamp", std::exchange(scene.shapes, {}));
         ASSERT_FALSE(
             add_instance(scene, group, then(scaling({-0.3, 1, 0.6}), then(rotation(40, {1, 2, 3}), translation({0.5, 0, 1.5}))), NO_MATERIAL));
     }},
    {"OneSided",
     [](Scene &scene) {
         scene.materials[1].record.flags |= MATERIAL_DARK_BACK;
         MeshData mesh;
         append_polygon(scene, mesh, {{-1, 1, 1}, {1, 1, 1.5f}, {1, -0.5f, 1.5f}, {-1, -0.5f, 1}}, {});
         append_polygon(scene, mesh, {{-1, 1, -1}, {1, 1, -1.5f}, {1, -0.5f, -1.5f}, {-1, -0.5f, -1}}, {});
         add_triangle_mesh(scene, 1, std::move(mesh));
     }},
};

/// At their horizon directions are infinitely dense: too much for sums over steps.
const std::vector<Lit> curved = {
    {"StretchedCone",
     [](Scene &scene) {
         add_frustum(scene, 1, {0, 0, 0}, 1, {0, 1, 0}, 0.5f);
         const uint group = add_group(scene, "lamp", std::exchange(scene.shapes, {}));
         ASSERT_FALSE(
             add_instance(scene, group, then(scaling({-0.3, 1, 0.6}), then(rotation(40, {1, 2, 3}), translation({0.5, 0, 1.5}))), NO_MATERIAL));
     }},
    {"Sphere",
     [](Scene &scene) {
         add_sphere(scene, 1, {0.5f, 0.4f, 1}, 0.9f);
     }},
    {"StretchedSphere",
     [](Scene &scene) {
         add_sphere(scene, 1, {0, 0, 0}, 1);
         const uint group = add_group(scene, "lamp", std::exchange(scene.shapes, {}));
         ASSERT_FALSE(
             add_instance(scene, group, then(scaling({-0.3, 1, 0.6}), then(rotation(40, {1, 2, 3}), translation({0.5, 0, 1.5}))), NO_MATERIAL));
     }},
};

/// Flat and round ones, chosen by the area that they have in the world.
void add_stretched_together(Scene &scene) {
    add_sphere(scene, 1, {0, 0, 0}, 0.5f), add_frustum(scene, 1, {0, 0, 1}, 0.5f, {0, 1, 1}, 0.2f);
    add_triangle(scene, 1, {-2, -1, 0.5f}, {-1, -1, 0}, {-2, 1, 0});
    add_disk(scene, 1, {0, -1, 1}, {0.2f, 1, -1}, 0.4f);
    const uint group = add_group(scene, "lamp", std::exchange(scene.shapes, {}));
    ASSERT_FALSE(add_instance(scene, group, then(scaling({-0.6, 1, 1.6}), then(rotation(40, {1, 2, 3}), translation({0.5, 0, 1.5}))), NO_MATERIAL));
    add_sphere(scene, 1, {-1, -1, 1}, 0.3f);
}

/// Where the half below a matte floor is hidden, and what is above shines, a picture with a bright spot included.
void add_everything(Scene &scene) {
    scene.background = Spectrum(1, 0.5f, 0.5f), scene.background_turn = 0.3f;
    std::vector<vec3> pixels(32 * 16, Spectrum(0.2f));
    pixels[5 * 32 + 7] = Spectrum(40, 30, 20), pixels[3 * 32 + 20] = Spectrum(0);
    scene.textures.push_back({"", {.wrap = TextureWrap::panorama}, {32, 16, pixels, {}}});
    scene.background_texture = 1;
    const uint bright = add_material(scene, emitter(Spectrum(3, 1, 0)));
    add_sphere(scene, bright, {0, 1, 2}, 0.4f), add_sphere(scene, 1, {-2, -1, 1}, 0.5f), add_frustum(scene, 1, {2, 0, 1}, 0.3f, {2, 1, 1}, 0.3f);
    scene.lights.push_back(directional_light({0, 0, -1}, Spectrum(0.1f)));  // from below the floor
    add_sphere(scene, 0, {0, 0, -100.5f}, 100);
}

Scene lit_scene(const Lit &lit) {
    Scene scene = empty_scene();
    scene.integrator.type = "path";
    add_material(scene, emitter(Spectrum(1)));
    lit.add(scene);
    add_sphere(scene, 0, {0, 0, -1000}, 1);  // without anything to light there are no lights
    return scene;
}

class EmissionDensity : public testing::TestWithParam<Lit> {};
class BothDensities : public testing::TestWithParam<Lit> {};

}  // namespace

/// Pearson's test of visible directions in cells of the sphere; those that are not, or are dark, are a cell of their own.
TEST_P(EmissionDensity, IsThatOfTheLightThatIsAsked) {
    LightAt light(lit_scene(GetParam()), {0, 0, 0});
    std::vector<double> expected(rings * sectors + 1);
    const std::vector<Ray> rays = regular_rays({0, 0, 0});
    const std::vector<vec2> met = light.met(rays);
    double sum = 0;
    for (uint i = 0; i < regular; ++i) {
        const double part = double(met[i].x) * 4 * std::numbers::pi / regular * asked;
        expected[cell_of(rays[i].direction)] += part, sum += part;
    }
    EXPECT_GT(sum, 0.3 * asked);
    EXPECT_LT(sum, 1.005 * asked);
    expected.back() = std::max(asked - sum, 0.0);

    std::vector<std::uint64_t> counts(expected.size());
    const std::vector<Ray> chosen = light.ask().rays;
    const std::vector<std::uint8_t> visible = light.visible(chosen);
    for (uint i = 0; i < asked; ++i) ++counts[visible[i] != 0 && chosen[i].t_max >= 0 ? cell_of(chosen[i].direction) : rings * sectors];
    // What the sum over steps is off by at edges of lamps, some 1e-4 of all, may be a small last cell.
    if (expected.back() < 1e-3 * asked && counts.back() < 1e-3 * asked) expected.pop_back(), counts.pop_back();
    EXPECT_TRUE(statistics::plausible(statistics::chi_square(counts, expected).p));
}

/// At every point that is asked and seen, what a ray would meet there is as dense as it was asked: both ways of finding it know each other. Rounding
/// sees edges of lamps and cells a little elsewhere, and turns normals by 1e-7 over the cosine, which is a hundredth of the cosine itself where that
/// is below 0.003.
TEST_P(BothDensities, AreThoseOfWhatIsAsked) {
    LightAt light(lit_scene(GetParam()), {0, 0, 0});
    LightAt::Asked chosen = light.ask();
    const std::vector<std::uint8_t> visible = light.visible(chosen.rays);
    std::vector<Ray> onward;
    for (const vec3 direction : chosen.directions) onward.push_back(make_ray({0, 0, 0}, direction));
    const std::vector<vec2> met = light.met(onward);
    uint seen = 0, off = 0;
    for (uint i = 0; i < asked; ++i) {
        if (visible[i] == 0 || chosen.rays[i].t_max < 0 || std::isinf(chosen.densities[i])) continue;
        ++seen;
        off += std::abs(met[i].x - chosen.densities[i]) > 1e-2f * chosen.densities[i];
    }
    EXPECT_GT(seen, asked / 4);
    EXPECT_LT(off, seen / 100);
}

/// Irradiance of a surface that faces z: of what is met in all directions, of what is asked alone, and of both as the power heuristic weighs them
/// where directions are met with density cosine / pi. What is summed up over steps, a thousandth may be off.
TEST_P(BothDensities, MakeTheSameLightOfOneWayOrBoth) {
    LightAt light(lit_scene(GetParam()), {0, 0, 0});
    const auto weight = [](double own, double other) { return own * own / (own * own + other * other); };
    const auto by_chance = [](vec3 direction) { return std::max(double(direction.z), 0.0) / std::numbers::pi; };

    const std::vector<Ray> rays = regular_rays({0, 0, 0});
    const std::vector<vec2> met = light.met(rays);
    double all = 0, weighted = 0;
    for (uint i = 0; i < regular; ++i) {
        const double chance = by_chance(rays[i].direction), part = double(met[i].y) * chance * 4 * std::numbers::pi * std::numbers::pi / regular;
        all += part;
        if (part > 0) weighted += part * weight(chance, double(met[i].x));
    }

    const LightAt::Asked chosen = light.ask();
    const std::vector<std::uint8_t> visible = light.visible(chosen.rays);
    std::vector<double> alone(asked), shared(asked);
    for (uint i = 0; i < asked; ++i) {
        if (visible[i] == 0 || chosen.rays[i].t_max < 0) continue;
        const double chance = by_chance(chosen.directions[i]);
        alone[i] = double(chosen.irradiances[i]) * chance * std::numbers::pi;
        shared[i] = alone[i] * weight(double(chosen.densities[i]), chance);
    }
    const statistics::Estimate expected{all, std::pow(1e-3 * all, 2)}, asked_alone = statistics::estimate_of(alone);
    statistics::Estimate both = statistics::estimate_of(shared);
    both.mean += weighted;
    EXPECT_TRUE(statistics::plausible({statistics::p_of_difference(asked_alone, expected), statistics::p_of_difference(both, expected)}))
        << asked_alone.mean << " asked alone, " << both.mean << " both ways, instead of " << all;
    EXPECT_LT(std::sqrt(asked_alone.variance), 0.01 * all) << "the test can tell";
}

INSTANTIATE_TEST_SUITE_P(Kernels, EmissionDensity, testing::ValuesIn(all_lit), [](const auto &info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(Kernels, BothDensities, testing::ValuesIn(all_lit), [](const auto &info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(KernelsOfCurved, BothDensities, testing::ValuesIn(curved), [](const auto &info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(KernelsTogether, BothDensities,
                         testing::Values(Lit{"Everything", add_everything}, Lit{"StretchedTogether", add_stretched_together}),
                         [](const auto &info) { return std::string(info.param.name); });
INSTANTIATE_TEST_SUITE_P(KernelsTogether, EmissionDensity, testing::Values(Lit{"Everything", add_everything}),
                         [](const auto &info) { return std::string(info.param.name); });

}  // namespace brandung
