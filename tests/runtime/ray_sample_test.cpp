/// The rays of a scene's render, taken for those who try accelerators, and what the counting kernels say of them.
#include "runtime/accelerators/ray_sample.h"

#include <gtest/gtest.h>

#include "runtime/accelerators/ray_tracing.h"
#include "tests/support/probe.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

using enum RayQueue::Use;

constexpr uint batch = 1024;

/// Mirroring spheres that see each other, before two lights.
Scene mirrors() {
    Scene scene = empty_scene();
    const uint material = add_material(scene, mirror(0.5f));
    Random random(3);
    for (uint i = 0; i < 60; ++i) add_sphere(scene, i % 2 ? material : 0, random.in_cube(1), 0.25f);
    scene.lights = {point_light({3, 4, 5}, Spectrum(10)), point_light({-3, 4, 5}, Spectrum(10))};
    scene.cameras.push_back({.name = "camera", .from = {0, 0, 4}, .at = {0, 0, 0}});
    scene.film.width = 72, scene.film.height = 60;
    scene.integrator.max_depth = 4;
    return scene;
}

struct Rendering {
    explicit Rendering(const Scene &scene)
        : compiled(compile(scene)),
          on_device(test_device(), compiled),
          renderer(test_device(), scene, compiled, on_device, scene.cameras[0], {.batch = batch}) {}
    CompiledScene compiled;
    DeviceScene on_device;
    Renderer renderer;
};

/// Of a whole render, and how many rays it had.
struct WholeSample {
    explicit WholeSample(const Scene &scene) {
        Rendering rendering(scene);
        Film film(test_device(), scene.film.window());
        rendering.renderer.render(film);
        counts = rendering.renderer.integrator().counts();
        sample = sample_rays(rendering.renderer, scene.film.window(), batch);
    }
    RayCounts counts;
    RaySample sample;
};

TEST(RaySample, HasTheRaysOfARender) {
    const auto [counts, sample] = WholeSample(mirrors());
    EXPECT_EQ(count_of(sample, camera), 72 * 60);
    EXPECT_EQ(count_of(sample, secondary), counts.rays[RAY_REFLECTED] + counts.rays[RAY_REFRACTED]);
    EXPECT_EQ(count_of(sample, RayQueue::Use::shadow), counts.rays[RAY_SHADOW]);
    for (const RayQueue &queue : sample) {
        EXPECT_GT(queue.count(), 0) << "the scene has all";
        EXPECT_EQ(queue.sources.size(), queue.rays.size());
        for (const Ray &ray : queue.rays) {
            EXPECT_EQ(RAY_KIND(ray.tag), queue.shadow ? RAY_SHADOW : queue.use == secondary ? RAY_REFLECTED : RAY_CAMERA);
            EXPECT_EQ(ray.t_max < 20, queue.shadow) << "ends at the light";
        }
    }
}

TEST(RaySample, HasTheRaysOfPaths) {
    Scene scene = mirrors();
    scene.integrator.type = "path";
    const auto [counts, sample] = WholeSample(scene);
    EXPECT_EQ(count_of(sample, camera), 72 * 60);
    EXPECT_EQ(count_of(sample, secondary), counts.rays[RAY_REFLECTED]);
    EXPECT_EQ(count_of(sample, RayQueue::Use::shadow), counts.rays[RAY_SHADOW]);
    for (const RayQueue &queue : sample) EXPECT_EQ(queue.count() == 0, queue.use == secondary && queue.coherent) << "paths scatter at once";
}

/// Of 4320 pixels in 68 runs, 5 % are 4 runs of 64.
TEST(RaySample, IsThinnedInRuns) {
    const Scene scene = mirrors();
    Rendering rendering(scene);
    const RaySample sample = sample_rays(rendering.renderer, scene.film.window(), batch, 216);
    EXPECT_EQ(count_of(sample, camera), 4 * 64);
    EXPECT_GT(count_of(sample, secondary), 0);
    EXPECT_LE(count_of(sample, secondary), 216 + 3 * 64);
    EXPECT_LE(count_of(sample, RayQueue::Use::shadow), 216 + 3 * 64);
    EXPECT_NE(sample[0].rays.front().direction.y > 0, sample[0].rays.back().direction.y > 0) << "from the upper half and the lower";
}

/// Work of all rays of a sample, closest hits and shadows apart.
std::array<WorkSums, 2> work_of(const RaySample &sample, Scene &scene, const std::string &accelerator) {
    scene.accelerator = accelerator;
    const CompiledScene compiled = compile(scene);
    const DeviceScene on_device(test_device(), compiled);
    RayTracing tracing(test_device(), compiled, on_device, batch);
    std::array<WorkSums, 2> sums;
    for (const RayQueue &queue : sample)
        for (std::size_t first = 0; first < queue.count(); first += batch) tracing.count(part_of(queue, first, batch), sums[queue.shadow]);
    return sums;
}

TEST(RaySample, WorkIsCounted) {
    Scene scene = mirrors();
    RaySample sample;
    RayCounts counts;
    {
        Rendering rendering(scene);
        sample = sample_rays(rendering.renderer, scene.film.window(), batch);
        counts = rendering.renderer.integrator().counts();
    }
    const auto [closest, shadows] = work_of(sample, scene, "none");
    EXPECT_EQ(closest.tests, 60 * closest.rays) << "every primitive, by every ray";
    EXPECT_EQ(closest.blocks, 8 * closest.rays) << "60 are 8 blocks";
    EXPECT_LT(shadows.tests, 60 * shadows.rays) << "a shadow ray ends with its first hit";
    EXPECT_GE(shadows.tests, 60 * (shadows.rays - shadows.hits));
    EXPECT_EQ(closest.steps + closest.cells + closest.listed, 0);
    EXPECT_EQ(closest.hits, counts.hits[RAY_CAMERA] + counts.hits[RAY_REFLECTED]);
    EXPECT_EQ(shadows.hits, counts.hits[RAY_SHADOW]);
    const auto [in_grid, shadows_in_grid] = work_of(sample, scene, "uniform_grid");
    for (const WorkSums &grid : {in_grid, shadows_in_grid}) {
        EXPECT_GT(grid.empty_cells, 0);
        EXPECT_LT(grid.empty_cells, grid.cells);
        EXPECT_LE(grid.cells, grid.steps);
        EXPECT_GT(grid.tests, 0);
        EXPECT_LE(grid.blocks, grid.tests);
        EXPECT_LE(grid.tests, 8 * grid.blocks);
    }
    EXPECT_EQ(in_grid.rays, closest.rays);
    EXPECT_EQ(in_grid.hits, closest.hits);
    EXPECT_EQ(shadows_in_grid.hits, shadows.hits);
}

}  // namespace
}  // namespace brandung
