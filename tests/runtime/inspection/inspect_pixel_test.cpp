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

/// What is added by a ray and all below it; checks on the way that the parts of each are the whole, to the bit.
std::array<__int128, 3> checked_sum(const TracedRay &ray, const Scene &scene) {
    std::array<__int128, 3> sum{};
    Spectrum radiance = ray.unlit;
    for (const TracedLightBlock &block : ray.lights) {
        for (const TracedLight &light : block.lights) {
            EXPECT_EQ(light.asked, why_not_asked(light).empty());
            if (light.asked && light.visible) radiance += light.radiance;
        }
        EXPECT_TRUE(same_bits(block.contribution, radiance * ray.path.throughput)) << "the lights one by one are not those of the block";
        const FixedPoint fixed = fixed_point(block.contribution);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += fixed[c];
        radiance = Spectrum(0);
    }
    for (std::size_t j = 0; ray.hits() && j < ray.children.size(); ++j) {
        const TracedChild &child = ray.children[j];
        EXPECT_EQ(child.traced != nullptr,
                  why_not_spawned(ray, RAY_KIND(child.ray.tag), scene.materials[ray.point.material].record, scene.integrator).empty());
        if (!child.traced) continue;
        EXPECT_TRUE(scene.integrator.follows_one || RAY_KIND(child.traced->begun.tag) == (j == 0 ? RAY_REFLECTED : RAY_REFRACTED));
        EXPECT_TRUE(same_bits(child.traced->begun, child.ray)) << "child " << j << " is another's";
        EXPECT_TRUE(same_bits(child.traced->path.throughput, ray.path.throughput * child.weight));
        EXPECT_EQ(child.traced->path.depth, ray.path.depth + 1);
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
                                         Picture{"TexturesFilteredByMitchell", mitchell_textures, meets_a_texture}),
                         [](const auto &info) { return info.param.name; });

}  // namespace
}  // namespace brandung
