/// The same bits, however the work is cut up.
#include <gtest/gtest.h>

#include "runtime/opencl/device.h"
#include "scene/bsdfs/bsdf.h"
#include "scene/lights/light.h"
#include "tests/images/oracle.h"
#include "tests/support/probe.h"
#include "tests/support/rendering.h"
#include "tests/support/scenes.h"

namespace {

using namespace brandung;

/// Every kind of primitive, material and light: matte, mirror and glass between coloured lights.
Scene scene_of_everything(uint width, uint height, uint spp) {
    Scene scene;
    scene.file = "everything";
    CameraDescription camera;
    camera.from = {0.2f, 0.4f, 3}, camera.at = {0, 0, 0}, camera.fov = glm::radians(45.0f);
    scene.cameras.push_back(camera);
    scene.film.width = width, scene.film.height = height, scene.film.spp = spp, scene.film.seed = 5;
    scene.background = {0.1f, 0.3f, 0.7f}, scene.ambient = Spectrum(0.05f);
    scene.integrator.max_depth = 5;
    Material shiny = make_material(
        Whitted{.ambient = Spectrum(0.3f), .diffuse = {0.6f, 0.3f, 0.1f}, .specular = Spectrum(0.4f), .reflection = Spectrum(0.3f), .exponent = 30});
    const uint matte_one = add_material(scene, matte(0.7f)), glass_one = add_material(scene, glass(1.5f)), shiny_one = add_material(scene, shiny);
    add_soup(scene, matte_one, {.of_each = 48, .size = 0.3f, .seed = 1});
    add_soup(scene, glass_one, {.of_each = 10, .size = 0.5f, .seed = 2});
    add_soup(scene, shiny_one, {.of_each = 33, .size = 0.4f, .seed = 3});
    scene.lights.push_back(point_light({2, 3, 2}, {9, 8, 7}));
    scene.lights.push_back(directional_light({-1, 1, 0.5f}, {0.5f, 0.6f, 0.9f}));
    scene.lights.push_back(spot_light({-2, 2, 2}, {0, 0, 0}, {5, 9, 6}, 50, 0.5));
    shiny.emission = {2, 1, 3};
    add_soup(scene, add_material(scene, shiny), {.counts = {{"sphere", 1}, {"triangle", 1}, {"frustum", 1}, {"disk", 1}}, .seed = 4});
    return scene;
}

/// What a render must repeat.
struct Result {
    std::uint64_t hash;
    std::array<std::uint64_t, RAY_KINDS> rays, hits;
    bool operator==(const Result &) const = default;
};
std::ostream &operator<<(std::ostream &out, const Result &result) {
    out << "film " << std::hex << result.hash << std::dec;
    for (uint kind = 0; kind < RAY_KINDS; ++kind) out << ", " << result.rays[kind] << " rays with " << result.hits[kind] << " hits";
    return out;
}

Result render(const Scene &scene, uint batch = 65536) {
    const Rendering rendering = render_scene(scene, {.batch = batch});
    EXPECT_EQ(rendering.refused, 0u);
    EXPECT_EQ(rendering.clamped, 0u);
    return {film_hash(rendering.film), rendering.counts.rays, rendering.counts.hits};
}

/// On a device of its own, with so many threads.
Result render_with_threads(const Scene &scene, uint threads) {
    Device device = Device::select("", threads);
    EXPECT_EQ(device.info().compute_units, threads);
    const CompiledScene compiled = compile(scene);
    const DeviceScene on_device(device, compiled);
    Film film(device, scene.film.window());
    Renderer renderer(device, scene, compiled, on_device, scene.cameras.at(0), {});
    renderer.render(film);
    return {film_hash(film.read()), renderer.integrator().counts().rays, renderer.integrator().counts().hits};
}

}  // namespace

/// One item per work-item, and rays of one lane; with media, filtered shadows and instances, for which all hits along a ray are gathered.
TEST(SameBits, WithTheKernelsOfGpus) {
    Scene scene = scene_of_everything(40, 30, 2);
    scene.integrator.filtered_shadows = true;
    Scene group;
    add_soup(group, 1, {.of_each = 5, .size = 0.5f, .seed = 9});
    add_group(scene, "group", std::move(group.shapes));
    ASSERT_FALSE(add_instance(scene, 0, translation({0.3f, 0, 0})));
    ASSERT_FALSE(add_instance(scene, 0, translation({-0.3f, 0.2f, 0})));
    Device as_gpu = Device::select("", 0, true);
    const Rendering expected = render_scene(scene), found = render_scene(as_gpu, scene);
    EXPECT_EQ(film_hash(found.film), film_hash(expected.film));
    EXPECT_EQ(found.counts.hits, expected.counts.hits);
    EXPECT_TRUE(as_gpu.kernels().contains("intersect") && as_gpu.kernels().contains("trace_shadow_rays_singly"));
    EXPECT_FALSE(as_gpu.kernels().contains("intersect_packets") || as_gpu.kernels().contains("intersect_interleaved"));
}

TEST(SameBits, FromRunToRun) {
    const Scene scene = scene_of_everything(64, 48, 4);
    const Result once = render(scene);
    EXPECT_EQ(once, render(scene));
    EXPECT_GT(once.rays[RAY_REFLECTED], 1000u);
    EXPECT_GT(once.rays[RAY_REFRACTED], 1000u);
    EXPECT_GT(once.hits[RAY_SHADOW], 1000u);
}

TEST(SameBits, ForEveryBatchSizeAndAnyNumberOfSamples) {
    for (const uint spp : {1u, 4u, 7u, 40u}) {
        const Scene scene = scene_of_everything(61, 37, spp);  // no multiple of anything
        const Result expected = render(scene);
        for (const uint batch : {1000u, 262144u, spp < 10 ? 77u : 777u})
            EXPECT_EQ(expected, render(scene, batch)) << spp << " samples, batch " << batch;
    }
}

/// Every ray alone.
TEST(SameBits, ForBatchesOfOneRay) {
    const Scene scene = scene_of_everything(8, 6, 3);
    const Result expected = render(scene);
    for (const uint batch : {1u, 2u, 3u}) EXPECT_EQ(expected, render(scene, batch)) << "batch " << batch;
}

TEST(SameBits, ForOneThreadAndTwo) {
    const Scene scene = scene_of_everything(64, 48, 4);
    const Result expected = render(scene);
    EXPECT_EQ(expected, render_with_threads(scene, 1));
    if (test_device().info().compute_units >= 2) {
        EXPECT_EQ(expected, render_with_threads(scene, 2));
    }
}

TEST(SameBits, ForEveryAccelerator) {
    Scene scene = scene_of_everything(64, 48, 2);
    const Result expected = render(scene);
    scene.accelerator = "none";
    EXPECT_EQ(expected, render(scene));
}

TEST(SameBits, ForEveryPixelPosition) {
    Scene scene = scene_of_everything(33, 21, 1);
    std::vector<std::uint64_t> hashes;
    for (const uint pixel : {PIXEL_CORNER, PIXEL_CENTER, PIXEL_RANDOM}) {
        scene.film.pixel = pixel;
        const Result expected = render(scene);
        EXPECT_EQ(expected, render(scene, 100));
        hashes.push_back(expected.hash);
    }
    EXPECT_NE(hashes[0], hashes[1]);
    EXPECT_NE(hashes[1], hashes[2]);
}

class ManyLights : public testing::TestWithParam<uint> {};

/// Lights come in blocks of 8. Each of n equal lights at one place brings 1 / n: one light's picture, whatever n.
TEST_P(ManyLights, AddUpToOneAndAreTheSameForEveryBatch) {
    const uint count = GetParam();
    Scene scene = scene_of_everything(40, 30, 1);
    scene.integrator.light_samples = 0;
    scene.lights.assign(1, point_light({2, 3, 2}, Spectrum(8)));
    const Rendering one = render_scene(scene);
    scene.lights.assign(count, point_light({2, 3, 2}, Spectrum(8.0f / count)));
    const Rendering many = render_scene(scene);
    EXPECT_EQ(many.counts.rays[RAY_SHADOW], count * one.counts.rays[RAY_SHADOW]);
    EXPECT_EQ(many.counts.hits[RAY_SHADOW], count * one.counts.hits[RAY_SHADOW]);
    for (std::size_t i = 0; i < one.picture.size(); ++i)
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(many.picture[i][c], one.picture[i][c], 1e-6f * (1 + count + one.picture[i][c])) << "pixel " << i;
    EXPECT_EQ(film_hash(many.film), render(scene, 1000).hash);
    scene.accelerator = "none";
    EXPECT_EQ(film_hash(many.film), render(scene).hash);
}

INSTANTIATE_TEST_SUITE_P(SameBits, ManyLights, testing::Values(2u, 7u, 8u, 9u, 16u, 20u),
                         [](const auto &info) { return "Lights" + std::to_string(info.param); });

/// Different lights in every block: each lights a matte floor from straight above with its own colour, and the sum is known.
TEST(SameBits, EveryLightOfEveryBlockCountsOnce) {
    Scene scene = scene_of_everything(16, 16, 1);
    scene.shapes.clear(), scene.lights.clear();
    scene.ambient = Spectrum(0);
    scene.cameras[0].from = {0, 3, 0.1f}, scene.cameras[0].fov = glm::radians(20.0f);
    add_triangle(scene, 0, {-8, 0, 8}, {8, 0, 8}, {0, 0, -16});
    Spectrum sum(0);
    for (uint i = 0; i < 20; ++i) {
        const Spectrum irradiance(std::exp2(-static_cast<float>(i)), 1, static_cast<float>(i * i));
        scene.lights.push_back(directional_light({0, 1, 0}, irradiance));
        sum += irradiance;
    }
    const Rendering rendering = render_scene(scene);
    EXPECT_EQ(rendering.counts.rays[RAY_SHADOW], 20u * 16 * 16);
    for (const vec3 &pixel : rendering.picture)
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(pixel[c], sum[c] * 0.7L / oracle::pi, 1e-6L * sum[c]);
}

/// What the film holds of four samples: counts, and sums, halves and squares that four numbers can have.
TEST(SameBits, FilmSumsFitTogether) {
    const Scene scene = scene_of_everything(32, 24, 4);
    const Rendering rendering = render_scene(scene);
    for (std::size_t i = 0; i < rendering.film.size(); ++i) {
        const FilmPixel &pixel = rendering.film[i];
        for (const uint half : {0u, 1u}) ASSERT_EQ(pixel.counts[half], 2u);
        for (int c = 0; c < 3; ++c) {
            const __int128 whole = sum_of(pixel, static_cast<std::size_t>(c));
            ASSERT_EQ(rendering.picture[i][c], static_cast<float>(whole) * 0x1p-32f / 4) << "develop is the mean";
            // Cauchy and Schwarz: (sum of 4)² <= 4 times the sum of squares, and the halves are part of the whole.
            const long double sum = static_cast<long double>(whole),
                              squares = static_cast<long double>(squares_of(pixel, static_cast<std::size_t>(c)));
            ASSERT_LE(sum * sum, 4 * squares * 1.0000001L) << "pixel " << i;
            ASSERT_GE(sum * sum * 1.0000001L, squares) << "radiance is not negative";
            for (const uint half : {0u, 1u}) ASSERT_GE(value_of(pixel.sums[half][c]), 0);
        }
    }
}

/// The left half of the one pixel is bright. Grids with an even number of columns cut it exactly, so that each half of the samples, alone, must
/// find 1/2.
TEST(SameBits, EachHalfOfThePixelsSamplesSeesAllOfThePixel) {
    Scene scene = scene_of_everything(1, 1, 1);
    scene.shapes.clear(), scene.lights.clear();
    scene.background = Spectrum(0), scene.ambient = Spectrum(0);
    scene.cameras[0].from = {0, 0, 3}, scene.cameras[0].at = {0, 0, 0};
    add_triangle(scene, add_material(scene, emitter(Spectrum(1))), {0, -100, 0}, {0, 100, 0}, {-100, 0, 0});
    for (const uint spp : {8u, 16u, 64u}) {
        scene.film.spp = spp;
        const FilmPixel pixel = render_scene(scene).film.at(0);
        for (const uint half : {0u, 1u}) EXPECT_TRUE(value_of(pixel.sums[half][0]) == std::int64_t{spp} << 30) << spp;
    }
}

TEST(SameBits, HalvesOfAnyNumberOfSamplesAreAsLargeAsTheyCanBe) {
    for (const uint spp : {1u, 2u, 3u, 5u, 26u}) {
        Scene scene = scene_of_everything(7, 5, spp);
        scene.background = Spectrum(1), scene.shapes.clear();
        const Rendering rendering = render_scene(scene);
        for (std::size_t i = 0; i < rendering.film.size(); ++i) {
            ASSERT_EQ(rendering.film[i].counts[0], spp - spp / 2);
            ASSERT_EQ(rendering.film[i].counts[1], spp / 2);
            ASSERT_EQ(rendering.picture[i], vec3(1)) << spp;
        }
    }
}
