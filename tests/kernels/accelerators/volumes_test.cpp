/// Volumes round groups of primitives: the line of every hit meets them, however it was rounded, and other lines do not.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "kernels/accelerators/bounding_volumes.h"
#include "scene/accelerators/volume_fit.h"
#include "tests/kernels/accelerators/hard_scenes.h"
#include "tests/support/probe.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_scene.h"

namespace brandung {
namespace {

/// A ray against a volume in its box.
struct Trial {
    Ray ray;
    vec3 low, high;
    float extent;
    uint kind;
    Volume volume;
};

Probe &volume_probe() {
    static Probe probe(
        R"(#include "kernels/accelerators/volumes.cl"
        typedef struct { Ray ray; vec3 low, high; float extent; uint kind; Volume volume; } Trial;
        kernel void probe(const global Trial *trials, global uint *met) {
            const global Trial *trial = trials + get_global_id(0);
            const ray_x8 ray = prepare(trial->ray, trial->extent);
            const Stretch stretch = stretch_in_box(trial->low, trial->high, &ray);
            met[get_global_id(0)] = stretch.near <= stretch.far && meets_volume(trial->kind, &trial->volume, line_of(&ray), stretch);
        })",
        {{"generated/time.cl", "#include \"kernels/core/no_time.cl\"\n"}, {"generated/work.cl", "#include \"kernels/accelerators/no_work.cl\"\n"}});
    return probe;
}

/// Primitives that are neighbours in the scene.
struct Neighbours {
    Bounds bounds;
    std::vector<HullPart> parts;
};

std::vector<Neighbours> groups_of(const Scene &scene, std::size_t size) {
    std::vector<Neighbours> groups;
    std::size_t number = 0;
    for (const auto &shape : scene.shapes)
        for (std::size_t i = 0; i < shape->count(); ++i, ++number) {
            if (number % size == 0) groups.emplace_back();
            groups.back().bounds.add(shape->bounds(i));
            const Hull hull = shape->hull(i);
            groups.back().parts.insert(groups.back().parts.end(), hull.parts.begin(), hull.parts.begin() + hull.count);
        }
    return groups;
}

float extent_of(const Scene &scene) {
    float extent = 0;
    for (const auto &shape : scene.shapes)
        for (std::size_t i = 0; i < shape->count(); ++i)
            for (int axis = 0; axis < 3; ++axis)
                extent = std::max({extent, std::abs(shape->bounds(i).low[axis]), std::abs(shape->bounds(i).high[axis])});
    return extent;
}

class Volumes : public testing::TestWithParam<SceneKind> {};

TEST_P(Volumes, AreMetByTheLineOfEveryHit) {
    Scene scene = GetParam().make();
    const std::vector<Ray> rays = make_rays(scene, GetParam().centre);
    const std::vector<Hit> hits = TracedScene(scene, "none").closest_hits(rays);
    const float extent = extent_of(scene);
    for (const std::size_t size : {1u, 5u})
        for (uint kind = VOLUME_NONE + 1; kind < VOLUME_KINDS; ++kind) {
            const std::vector<Neighbours> groups = groups_of(scene, size);
            std::vector<Volume> volumes;
            for (const Neighbours &group : groups) volumes.push_back(fit_volumes(group.parts)[kind]);
            std::vector<Trial> of_hits, of_others;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const std::size_t hit = hits[i].primitive / size, other = i % groups.size();
                if (hits[i].primitive != NO_HIT)
                    of_hits.push_back({rays[i], groups[hit].bounds.low, groups[hit].bounds.high, extent, kind, volumes[hit]});
                of_others.push_back({rays[i], groups[other].bounds.low, groups[other].bounds.high, extent, kind, volumes[other]});
            }
            std::size_t lost = 0, met = 0;
            for (const uint one : volume_probe().run<uint>(of_hits)) lost += one == 0;
            for (const uint one : volume_probe().run<uint>(of_others)) met += one != 0;
            EXPECT_EQ(lost, 0u) << "kind " << kind << ", groups of " << size << ", of " << of_hits.size();
            EXPECT_LT(met, 9 * of_others.size() / 10) << "kind " << kind;
        }
}

std::vector<SceneKind> scenes_without_instances() {
    std::vector<SceneKind> kinds;
    for (const SceneKind &kind : scene_kinds())
        if (kind.make().instances.empty() && std::string(kind.name) != "one_sphere") kinds.push_back(kind);
    return kinds;
}

INSTANTIATE_TEST_SUITE_P(HardScenes, Volumes, testing::ValuesIn(scenes_without_instances()),
                         [](const auto &info) { return std::string(info.param.name); });

/// Of all lines through a convex body, those that meet another in it are in the ratio of their surfaces (Crofton's formula): a ball in its cube pi
/// / 6.
TEST(VolumeFit, LinesMeetABallInItsCubeAsOftenAsSurfacesSay) {
    const HullPart ball{.center = {1, 2, 3}, .radius = 2};
    const Bounds cube{{-1, 0, 1}, {3, 4, 5}};
    const std::vector<HullPart> parts = {ball}, larger = {{.center = {1, 2, 3}, .radius = 9}};
    const double expected = M_PI / 6, standard_error = std::sqrt(expected * (1 - expected) / 64);
    for (const uint kind : {VOLUME_SPHERE, VOLUME_ELLIPSOID}) {
        const Volume volume = fit_volumes(parts)[kind];
        EXPECT_NEAR(part_of_lines(kind, volume, cube), expected, 2 * standard_error) << kind;
    }
    EXPECT_EQ(part_of_lines(VOLUME_ORIENTED_BOX, fit_volumes(larger)[VOLUME_ORIENTED_BOX], cube), 1);
}

}  // namespace
}  // namespace brandung
