/// kernels/stages/group_hits.cl: hits of one kind of BSDF side by side, and with each all that is known of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "kernels/core/items.h"
#include "runtime/wavefront/device_scene.h"
#include "scene/bsdfs/bsdf.h"
#include "scene/bsdfs/choosing.h"
#include "scene/compile.h"
#include "scene/kinds.h"
#include "tests/support/probe.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

constexpr std::size_t group = 1024, others = 5;  ///< so many items of the list belong to others, before and after

/// Spheres of three kinds, one of them of glass, and one whose material chooses among two of them.
Scene scene_of_kinds() {
    Scene scene = empty_scene();
    scene.integrator.type = "path";
    const uint shiny = add_material(scene, mirror(0.9f)), clear = add_material(scene, glass(1.5f)),
               dull = add_material(scene, make_null(Spectrum(1)));
    const uint mix = add_material(scene, make_choosing(choosing_kinds()[kind_number(choosing_kinds(), "mix")], {{shiny, dull}, 0, Spectrum(0.5f)}));
    for (const uint material : {0u, clear, dull, mix}) add_sphere(scene, material, {float(material), 0, 0}, 0.4f);
    return scene;
}

/// What stages know of a list's items, in words.
struct Known {
    std::vector<uint> words;
    uint each;  ///< words of an item
    std::vector<uint> in_order(const std::vector<std::size_t> &order, std::size_t before = 0) const {
        std::vector<uint> result = words;
        for (std::size_t c = 0; c < order.size(); ++c)
            std::copy_n(words.begin() + std::ptrdiff_t((before + order[c]) * each), each, result.begin() + std::ptrdiff_t((before + c) * each));
        return result;
    }
};

Known random_words(Random &random, std::size_t count, uint each) {
    Known known{std::vector<uint>(count * each), each};
    for (uint &word : known.words) word = random.below(1u << 30);
    return known;
}

class GroupHits : public testing::TestWithParam<Kinds> {};

TEST_P(GroupHits, AreInTheOrderOfTheirKindsWithAllThatIsKnown) {
    if (!test_device().info().cpu) GTEST_SKIP() << "of CPUs only";
    const CompiledScene compiled = compile(scene_of_kinds(), {.kinds = GetParam()});
    const DeviceScene on_device(test_device(), compiled);
    Kernel kernel(test_device(), "kernels/stages/group_hits.cl", "group_hits", on_device.lists());
    const auto *materials = reinterpret_cast<const Material *>(compiled.arena.data() + 64 * std::size_t{compiled.header.materials.offset});
    Random random(7);
    for (const std::size_t count : {std::size_t{1}, std::size_t{63}, group, group + 1, 3 * group + 77}) {
        Known live = random_words(random, count + 2 * others, 1), hits = random_words(random, count, 4), chosen = random_words(random, count, 1);
        Known places = random_words(random, count, compiled.place_words()), beyond = random_words(random, count, compiled.interior_size);
        const Known etas = random_words(random, count, 1);
        std::vector<uint> kinds(count);
        for (std::size_t i = 0; i < count; ++i) {
            const uint primitive = random.below(5);
            hits.words[4 * i + 3] = primitive < 4 ? primitive : NO_HIT, chosen.words[i] = random.below(4);
            if (places.each > 0) places.words[i * places.each] = 0;  // the world
            kinds[i] = primitive < 4 ? materials[chosen.words[i]].kind : 1000;
        }
        std::vector<std::size_t> order(count);
        std::iota(order.begin(), order.end(), std::size_t{0});
        for (std::size_t begin = 0; begin < count; begin += group)
            std::stable_sort(order.begin() + std::ptrdiff_t(begin), order.begin() + std::ptrdiff_t(std::min(begin + group, count)),
                             [&](std::size_t a, std::size_t b) { return kinds[a] < kinds[b]; });
        const auto buffer = [&](const Known &known) { return Buffer<uint>(test_device(), known.words); };
        const Buffer<uint> d_live = buffer(live), d_hits = buffer(hits), d_places = buffer(places), d_beyond = buffer(beyond), d_etas = buffer(etas),
                           d_chosen = buffer(chosen);
        kernel(count, on_device, d_live, uint(others), uint(count), d_hits, d_places, d_beyond, d_etas, d_chosen);
        EXPECT_EQ(d_live.read(), live.in_order(order, others));
        EXPECT_EQ(d_hits.read(), hits.in_order(order));
        EXPECT_EQ(d_places.read(), places.in_order(order));
        EXPECT_EQ(d_beyond.read(), beyond.in_order(order));
        EXPECT_EQ(d_etas.read(), etas.in_order(order));
        EXPECT_EQ(d_chosen.read(), chosen.in_order(order));
    }
}

INSTANTIATE_TEST_SUITE_P(Stages, GroupHits, testing::Values(Kinds::in_use, Kinds::all),
                         [](const auto &info) { return info.param == Kinds::all ? "AllKinds" : "KindsInUse"; });

}  // namespace
}  // namespace brandung
