/// Inspected pixels: the same bits as a render's, and trees that add up to them.
#include "runtime/inspection/inspect_pixel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "runtime/inspection/reasons.h"
#include "scene/formats/format.h"
#include "tests/runtime/inspection/inspected.h"
#include "tests/support/rendering.h"

namespace brandung {
namespace {

/// Whitted's lights, times throughput all at once, what needs no light first.
void check_lights(const TracedRay &ray) {
    Spectrum radiance = ray.unlit;
    for (const TracedLightBlock &block : ray.lights) {
        for (const TracedLight &light : block.lights)
            if (light.asked && light.visible) radiance += light.radiance;
        EXPECT_TRUE(same_bits(block.contribution, radiance * ray.path.throughput)) << "the lights one by one are not those of the block";
        radiance = Spectrum(0);
    }
}

/// What was chosen makes up what is asked for.
void check_choice(const TracedLight &light, std::size_t count) {
    const AskedDescription &chosen = *light.chosen;
    const Spectrum expected = chosen.value * chosen.irradiance * chosen.weight / (chosen.chance * float(count));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(light.radiance[c], expected[c], 1e-5 * expected[c]);
}

/// Those that paths have asked, each times throughput, then what the ray has met.
void check_asked_lights(const TracedRay &ray) {
    EXPECT_TRUE(same_bits(ray.unlit, ray.met->radiance * ray.met->weight));
    ASSERT_EQ(ray.lights.size(), 1u);
    Spectrum contribution(0);
    for (const TracedLight &light : ray.lights[0].lights) {
        if (light.asked) check_choice(light, ray.lights[0].lights.size());
        if (light.asked && light.visible) contribution += ray.path.throughput * light.radiance;
    }
    EXPECT_TRUE(same_bits(ray.lights[0].contribution, ray.unlit * ray.path.throughput + contribution));
}

void check_child(const TracedRay &ray, std::size_t j, const Scene &scene) {
    const TracedChild &child = ray.children[j];
    EXPECT_EQ(child.traced != nullptr,
              why_not_spawned(ray, RAY_KIND(child.ray.tag), scene.materials[ray.point.material].record, scene.integrator).empty());
    if (!child.traced) return;
    EXPECT_TRUE(scene.integrator.follows_one || RAY_KIND(child.traced->begun.tag) == (j == 0 ? RAY_REFLECTED : RAY_REFRACTED));
    EXPECT_TRUE(same_bits(child.traced->path.throughput, ray.path.throughput * child.weight));
}

/// A part of a bundle, or the only one: chance that ends paths makes up for itself, and the parts share.
void check_part(const TracedRay &ray, std::size_t j, const Scene &scene) {
    const TracedChild &child = ray.children[j];
    EXPECT_EQ(child.traced != nullptr, why_not_continued(ray, child, scene.integrator).empty());
    if (!child.traced) return;
    const float share = 1 / float(ray.children.size());
    EXPECT_TRUE(same_bits(child.traced->path.throughput, ray.path.throughput * child.chosen->scattered * (share / child.chosen->survival)));
    const SamplePart before = part_of_sample(ray), part = part_of_sample(*child.traced);
    EXPECT_EQ(part.count, before.count * ray.children.size());
    EXPECT_EQ(part.number, before.number * ray.children.size() + j);
}

/// What is added by a ray and all below it; checks on the way that the parts of each are the whole, to the bit.
std::array<__int128, 3> checked_sum(const TracedRay &ray, const Scene &scene) {
    const bool paths = scene.integrator.traces_paths();
    paths ? check_asked_lights(ray) : check_lights(ray);
    std::array<__int128, 3> sum{};
    for (const TracedLightBlock &block : ray.lights) {
        for (const TracedLight &light : block.lights) EXPECT_EQ(light.asked, why_not_asked(light).empty());
        const FixedPoint fixed = fixed_point(block.contribution);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += fixed[c];
    }
    for (std::size_t j = 0; ray.hits() && j < ray.children.size(); ++j) {
        const TracedChild &child = ray.children[j];
        paths ? check_part(ray, j, scene) : check_child(ray, j, scene);
        if (!child.traced) continue;
        EXPECT_TRUE(same_bits(child.traced->begun, child.ray)) << "child " << j << " is another's";
        EXPECT_EQ(surface_number(*child.traced), surface_number(ray) + 1);
        const auto below = checked_sum(*child.traced, scene);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += below[c];
    }
    return sum;
}

using RayPredicate = bool (*)(const TracedRay &ray);

/// Whether it holds of a ray or of one below it.
bool any_ray(const TracedRay &ray, RayPredicate holds) {
    const auto below = [&](const TracedChild &child) { return child.traced && any_ray(*child.traced, holds); };
    return holds(ray) || std::any_of(ray.children.begin(), ray.children.end(), below);
}

bool in_two_media(const TracedRay &ray) { return std::count(ray.before.begin(), ray.before.end(), 0u) + 2 <= std::ssize(ray.before); }
bool lit_through_something(const TracedRay &ray) {
    const auto lit = [](const TracedLight &light) { return light.asked && light.visible && !light.passed.empty(); };
    const auto in_block = [&](const TracedLightBlock &block) { return std::any_of(block.lights.begin(), block.lights.end(), lit); };
    return std::any_of(ray.lights.begin(), ray.lights.end(), in_block);
}
bool lit_in_blocks(const TracedRay &ray) { return ray.lights.size() > 1; }
bool meets_an_instance(const TracedRay &ray) { return ray.instance > 0; }
bool meets_a_texture(const TracedRay &ray) { return ray.hits() && ray.tints && ray.tints->diffuse != Spectrum(1); }

bool ends_by_chance(const TracedRay &ray) {
    const auto ended = [](const TracedChild &child) { return !child.traced && child.chosen && child.chosen->refusals == PATH_ENDED; };
    return std::any_of(ray.children.begin(), ray.children.end(), ended);
}
bool meets_weighted_light(const TracedRay &ray) { return ray.met && ray.met->weight < 1 && ray.unlit != Spectrum(0); }
bool meets_weighted_background(const TracedRay &ray) { return !ray.hits() && meets_weighted_light(ray); }
bool is_one_of_several(const TracedRay &ray) { return part_of_sample(ray).count > 1 && ray.lights[0].lights[0].asked; }
bool refracts(const TracedRay &ray) { return ray.hits() && ray.children.at(0).traced && RAY_KIND(ray.children[0].ray.tag) == RAY_REFRACTED; }

/// A scene, and what must happen to some ray of the pixels that are inspected, so that they test what the scene is for.
struct Picture {
    const char *name;
    Scene (*make)();
    RayPredicate shows;
};
void PrintTo(const Picture &picture, std::ostream *out) { *out << picture.name; }

Scene example(const char *name, std::vector<std::string> settings) {
    settings.insert(settings.end(), {"film.width=16", "film.height=12"});
    return read_scene(std::string(BRANDUNG_SOURCE_DIR "/scene/examples/") + name, {settings, {}, {}});
}

/// At 12, 9 is the shadow of the glass ball.
Scene shadow_of_glass() { return example("whitted_1980.json", {"film.spp=16", "integrator.shadows=filtered"}); }
/// Plates of rough glass, plastic and metal, whose hits are grouped by these kinds.
Scene materials() { return example("materials.json", {"film.spp=64", "integrator.max_depth=5"}); }
Scene mitchell_textures() { return example("textures.json", {"film.spp=4", "film.filter=mitchell"}); }

class InspectedPicture : public testing::TestWithParam<Picture> {};

/// A batch of 2 rays makes many small waves.
TEST_P(InspectedPicture, HasTheBitsOfTheRenderAndTreesThatAddUpToThem) {
    const Scene scene = GetParam().make();
    const Rendering rendering = render_scene(scene);
    const uint spp = scene.film.spp, places[][2] = {{8, 6}, {12, 9}};
    bool shown = false;
    for (const auto &[x, y] : places) {
        const std::size_t place = y * scene.film.width + x;
        for (const uint batch : {2u, 256u}) {
            const InspectedPixel pixel = inspect(scene, x, y, {0, spp}, batch);
            EXPECT_TRUE(same_bits(pixel.film, rendering.film[place])) << x << "," << y;
            EXPECT_TRUE(same_bits(pixel.radiance, rendering.picture[place])) << x << "," << y;
            ASSERT_EQ(pixel.samples.size(), spp);
            for (uint i = 0; i < spp; ++i) {
                EXPECT_EQ(pixel.samples[i].number, i);
                shown |= any_ray(pixel.samples[i].ray, GetParam().shows);
                const auto sum = checked_sum(pixel.samples[i].ray, scene);
                for (std::size_t c = 0; c < 3; ++c) EXPECT_TRUE(sum[c] == value_of(pixel.samples[i].sum.sum[c])) << "sample " << i;
            }
        }
        const InspectedPixel one = inspect(scene, x, y, {spp - 1, 1});
        EXPECT_TRUE(same_bits(one.film, rendering.film[place])) << "all samples count, not only those that are kept";
        ASSERT_EQ(one.samples.size(), 1u);
        EXPECT_EQ(one.samples[0].number, spp - 1);
    }
    EXPECT_TRUE(shown);
}

INSTANTIATE_TEST_SUITE_P(Scenes, InspectedPicture,
                         testing::Values(Picture{"NestedGlass", [] { return example("nested_glass.json", {"film.spp=1"}); }, in_two_media},
                                         Picture{"OneOfTwoRays",
                                                 [] {
                                                     return example("nested_glass.json", {"film.spp=8", "integrator.follow=one"});
                                                 },
                                                 in_two_media},
                                         Picture{"FilteredShadowAtSixteen", shadow_of_glass, lit_through_something},
                                         Picture{"LampsInBlocks", [] { return example("lamps.json", {"film.spp=4"}); }, lit_in_blocks},
                                         Picture{"Instances", [] { return example("instances.json", {"film.spp=2"}); }, meets_an_instance},
                                         Picture{"TexturesFilteredByMitchell", mitchell_textures, meets_a_texture},
                                         Picture{"PathsThatEndByChance", [] { return example("path.json", {"film.spp=32"}); }, ends_by_chance},
                                         Picture{"PathsThatMeetLamps", [] { return example("path.json", {"film.spp=64"}); }, meets_weighted_light},
                                         Picture{"PathsOfSeveralKinds", materials, refracts},
                                         Picture{"PathsThatMeetTheSun", [] { return example("environment.json", {"film.spp=16"}); },
                                                 meets_weighted_background},
                                         Picture{"Bundles", [] { return example("distributed.json", {"film.spp=2"}); }, is_one_of_several}),
                         [](const auto &info) { return info.param.name; });

}  // namespace
}  // namespace brandung
