/// The Standard Procedural Databases: rays counted against a second ray tracer and against the published counts.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "scene/formats/format.h"
#include "tests/images/spd_reference.h"
#include "tests/support/probe.h"
#include "tests/support/rendering.h"

namespace {

using namespace brandung;

constexpr uint resolution = 513;

enum Count { PRIMARY, PRIMARY_HITS, SHADOW, SHADOW_HITS, SECONDARY, SECONDARY_HITS, COUNTS };
constexpr const char *count_names[COUNTS] = {"primary rays", "primary hits", "shadow rays", "shadow hits", "secondary rays", "secondary hits"};
using CountArray = std::array<std::uint64_t, COUNTS>;

/// Why a published count differs: with these conventions the reference counts what Havran counted, within a part `tolerance`.
struct Cause {
    std::vector<Count> counts;
    double tolerance;
    const char *why;
    spd::Conventions conventions;
    bool all_inner_shadow_rays_hit = false;
};

struct Published {
    const char *name;
    CountArray havran;                              ///< data/spd/EXPECTED.md
    std::uint64_t readme_shadow, readme_secondary;  ///< data/spd/Readme.txt
    std::vector<Cause> causes;
    std::vector<Count> unexplained;  ///< within 10 % nevertheless
};
void PrintTo(const Published &published, std::ostream *out) { *out << published.name; }

// What causes were found, by switching conventions in the reference until it counted what Havran did:
// * His spawned rays begin at t = 0.01 (the `hither` of two of the scenes). Where bodies touch or run into each other, rays leave through walls
//   thinner than that: balls -0.06 and -0.07 % instead of -2.2 and -5.7 % (secondary rays and hits), gears' secondary hits -0.003 % instead of
//   +5.1 %, mount's shadow hits -1.1 % instead of +3.4 %, teapot's secondary hits +0.9 % instead of +1.4 %.
// * gears: light falls on the outside of transparent surfaces, so a ray to a light from their inside passes them at once; all of those count as hits:
//   +0.34 % instead of -20.6 %. Ours begin outside.
// * rings: opaque surfaces have one side (rule 2 of the readme allows it): all counts within 0.05 %, instead of up to +2.3 %. It matters only because
//   his rays get into the pipes by beginning at 0.01.
// * teapot: light falls only where both the interpolated and the geometric normal face it: shadow rays -0.01 % instead of +1.0 %. Of these fewer hit:
//   he has 34,757, with front faces only -5.5 %, with both sides +16 %; which rays he has beyond is not known.
// * tree: he has 1.1 % more shadow rays than the readme, which has ours within 0.04 %, and 9 % more hits; no convention tried (cones' normals without
//   slope or with the opposite one, one-sided surfaces, beginnings of rays, numbers rounded to float) gives both. POV-Ray 3.7, in double, counts
//   43,606 hits for our 43,395.
const spd::Conventions late{.start = 0.01};
const spd::Conventions late_and_one_sided{.one_sided = true, .one_sided_shadows = true, .start = 0.01};
const spd::Conventions both_normals{.both_normals_lit = true, .one_sided_shadows = true};

const std::vector<Published> scenes = {
    {"balls_s4",
     {263169, 263169, 959244, 285178, 179884, 134368},
     954368,
     175095,
     {{{SECONDARY, SECONDARY_HITS}, 0.001, "his spawned rays begin at 0.01", late}},
     {}},
    {"gears_s4",
     {263169, 245332, 2088012, 1057557, 494338, 365338},
     2246955,
     304643 + 207564,
     {{{SHADOW, SHADOW_HITS}, 0.004, "his spawned rays begin at 0.01, those to lights on the wrong side of transparent surfaces", late, true},
      {{SECONDARY_HITS}, 0.001, "his spawned rays begin at 0.01", late}},
     {}},
    {"mount_s6",
     {263169, 173685, 361037, 74555, 710436, 472351},
     412922,
     2 * 354769,
     {{{SHADOW, SECONDARY, SECONDARY_HITS}, 0.004, "his spawned rays begin at 0.01", late}, {{SHADOW_HITS}, 0.012, "the same", late}},
     {}},
    {"rings_s7",
     {263169, 263169, 1077336, 510719, 312879, 175688},
     1085002,
     315236,
     {{{SHADOW, SHADOW_HITS, SECONDARY, SECONDARY_HITS}, 0.001, "his surfaces have one side, his spawned rays begin at 0.01", late_and_one_sided}},
     {}},
    {"teapot_s6",
     {263169, 161546, 406340, 34757, 226235, 67688},
     407656,
     225248,
     {{{SHADOW}, 0.001, "for light both normals must face it", both_normals},
      {{SHADOW_HITS}, 0.06, "the same, and shadow rays see front faces only", both_normals},
      {{SECONDARY_HITS}, 0.01, "his spawned rays begin at 0.01", late}},
     {}},
    {"tetra_s6", {263169, 49950, 46262, 5538, 0, 0}, 46112, 0, {}, {}},
    {"tree_s11", {263169, 169907, 1110323, 47506, 0, 0}, 1097419, 0, {}, {SHADOW_HITS}},
};

CountArray array_of(const spd::Counts &counts) {
    return {counts.primary, counts.primary_hits, counts.shadow, counts.shadow_hits, counts.secondary(), counts.secondary_hits()};
}

CountArray array_of(const RayCounts &counts) {
    return {counts.rays[RAY_CAMERA],
            counts.hits[RAY_CAMERA],
            counts.rays[RAY_SHADOW],
            counts.hits[RAY_SHADOW],
            counts.rays[RAY_REFLECTED] + counts.rays[RAY_REFRACTED],
            counts.hits[RAY_REFLECTED] + counts.hits[RAY_REFRACTED]};
}

double difference(std::uint64_t ours, std::uint64_t other) {
    return other == 0 ? static_cast<double>(ours) : static_cast<double>(ours) / static_cast<double>(other) - 1;
}

bool lies_between(std::uint64_t value, std::uint64_t a, std::uint64_t b) { return value >= std::min(a, b) && value <= std::max(a, b); }

class SpdScene : public testing::TestWithParam<Published> {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(file())) GTEST_SKIP() << "needs " << file() << ": set BRANDUNG_DATA";
    }
    static std::string file() { return std::string(BRANDUNG_DATA) + "/spd/" + GetParam().name + ".nff"; }

    static Scene read(uint size = resolution) {
        Scene scene = read_scene(file());
        scene.film.width = scene.film.height = size;
        scene.film.spp = 1, scene.film.pixel = PIXEL_CORNER;
        scene.integrator.max_depth = 5;
        return scene;
    }

    /// The picture that all cases look at, rendered once.
    static const Rendering &rendering() {
        static std::map<std::string, Rendering> known;
        const auto found = known.find(GetParam().name);
        return found != known.end() ? found->second : known.emplace(GetParam().name, render_scene(read())).first->second;
    }
    static const spd::Reference &reference() {
        static std::map<std::string, spd::Reference> known;
        return known.try_emplace(GetParam().name, file()).first->second;
    }
};

void expect_same(const Rendering &a, const Rendering &b) {
    EXPECT_EQ(film_hash(a.film), film_hash(b.film));
    EXPECT_EQ(a.counts.rays, b.counts.rays);
    EXPECT_EQ(a.counts.hits, b.counts.hits);
}

}  // namespace

/// Measured: equal but for 0.03 %: single precision decides on rays that graze.
TEST_P(SpdScene, CountsAreThoseOfTheReference) {
    const CountArray ours = array_of(rendering().counts), expected = array_of(reference().count(resolution, resolution));
    for (uint i = 0; i < COUNTS; ++i) {
        constexpr double tolerance = 0.0005;
        EXPECT_NEAR(static_cast<double>(ours[i]), static_cast<double>(expected[i]), tolerance * static_cast<double>(expected[i])) << count_names[i];
        RecordProperty(fmt::format("{}: ours, reference, difference", count_names[i]),
                       fmt::format("{}, {}, {:+.4f} %", ours[i], expected[i], 100 * difference(ours[i], expected[i])));
    }
    EXPECT_EQ(ours[PRIMARY], expected[PRIMARY]);
    EXPECT_EQ(rendering().refused, 0u);
    EXPECT_EQ(rendering().clamped, 0u);
}

/// Reflected and refracted rays apart, which the published counts are not.
TEST_P(SpdScene, ReflectedAndRefractedRaysAreThoseOfTheReference) {
    const spd::Counts expected = reference().count(resolution, resolution);
    const RayCounts &ours = rendering().counts;
    const auto expect_near = [](std::uint64_t a, std::uint64_t b) {
        EXPECT_NEAR(static_cast<double>(a), static_cast<double>(b), 0.0005 * static_cast<double>(b));
    };
    expect_near(ours.rays[RAY_REFLECTED], expected.reflected);
    expect_near(ours.hits[RAY_REFLECTED], expected.reflected_hits);
    expect_near(ours.rays[RAY_REFRACTED], expected.refracted);
    expect_near(ours.hits[RAY_REFRACTED], expected.refracted_hits);
}

TEST_P(SpdScene, CountsAreThePublishedOnesOrTheCauseIsKnown) {
    const Published &published = GetParam();
    const CountArray ours = array_of(rendering().counts);
    EXPECT_EQ(ours[PRIMARY], published.havran[PRIMARY]);
    EXPECT_LE(std::abs(difference(ours[PRIMARY_HITS], published.havran[PRIMARY_HITS])), 0.003);
    for (const Count i : {SHADOW, SHADOW_HITS, SECONDARY, SECONDARY_HITS}) {
        SCOPED_TRACE(fmt::format("{}: {}, Havran {} ({:+.2f} %)", count_names[i], ours[i], published.havran[i],
                                 100 * difference(ours[i], published.havran[i])));
        const std::uint64_t readme = i == SHADOW ? published.readme_shadow : i == SECONDARY ? published.readme_secondary : published.havran[i];
        if (std::abs(difference(ours[i], published.havran[i])) <= 0.01 || lies_between(ours[i], published.havran[i], readme)) continue;
        const auto explains = [&](const Cause &cause) { return std::find(cause.counts.begin(), cause.counts.end(), i) != cause.counts.end(); };
        const bool unexplained = std::find(published.unexplained.begin(), published.unexplained.end(), i) != published.unexplained.end();
        const bool explained = std::any_of(published.causes.begin(), published.causes.end(), explains);
        EXPECT_TRUE(explained || unexplained) << "differs, and no cause is known";
        if (unexplained) {
            EXPECT_LE(std::abs(difference(ours[i], published.havran[i])), 0.1);
        }
    }
}

/// The reference, which counts what we count (above), counts what Havran counted under the conventions that are said to be his.
TEST_P(SpdScene, CausesReproduceThePublishedCounts) {
    for (const Cause &cause : GetParam().causes) {
        const spd::Counts counts = reference().count(resolution, resolution, cause.conventions);
        CountArray changed = array_of(counts);
        if (cause.all_inner_shadow_rays_hit) changed[SHADOW_HITS] += counts.inner_shadow - counts.inner_shadow_hits;
        for (const Count i : cause.counts)
            EXPECT_LE(std::abs(difference(changed[i], GetParam().havran[i])), cause.tolerance)
                << count_names[i] << ": " << changed[i] << " where " << cause.why << ", Havran " << GetParam().havran[i];
    }
}

TEST_P(SpdScene, BatchesAndThreadsChangeNoBit) {
    const Scene scene = read();
    for (const uint batch : {262144u, 1000u}) {
        SCOPED_TRACE(batch);
        expect_same(rendering(), render_scene(scene, {.batch = batch}));
    }
    Device device = Device::select("", 1);
    const CompiledScene compiled = compile(scene);
    const DeviceScene on_device(device, compiled);
    Film film(device, resolution, resolution);
    Renderer renderer(device, scene, compiled, on_device, scene.cameras.at(0), {});
    renderer.render(film);
    EXPECT_EQ(film_hash(film.read()), film_hash(rendering().film)) << "one thread";
    EXPECT_EQ(renderer.integrator().counts().rays, rendering().counts.rays);
    EXPECT_EQ(renderer.integrator().counts().hits, rendering().counts.hits);
}

/// A quarter of the picture's width, since `none` tests every primitive for every ray.
TEST_P(SpdScene, AcceleratorsChangeNoBit) {
    Scene scene = read(129);
    const Rendering expected = render_scene(scene);
    scene.accelerator = "none";
    expect_same(expected, render_scene(scene));
}

INSTANTIATE_TEST_SUITE_P(All, SpdScene, testing::ValuesIn(scenes), [](const auto &info) { return info.param.name; });

/// The reference alone: a few counts by hand, so that the two tracers cannot be wrong together in the same way.
TEST(SpdReference, CountsASphereOverAFloorByHand) {
    const std::string file = testing::TempDir() + "spd_reference_test.nff";
    {
        std::ofstream out(file);
        // Straight down on a mirror floor; the lamp is above; a glass ball in the middle of the view.
        out << "v\nfrom 0 0 10\nat 0 0 0\nup 0 1 0\nangle 20\nresolution 3 3\nl 0 0 5\nf 1 1 1 1 0.5 1 0 1\np 4\n-99 -99 0\n99 -99 0\n99 99 0\n-99 "
               "99 0\n"
               "f 1 1 1 0 0 1 1 1.5\ns 0 0 2 1\n";
    }
    const spd::Counts counts = spd::Reference(file).count(3, 3);
    std::filesystem::remove(file);
    // 3 x 3 corners at 0, ±tan 10° 10 = ±1.76 on the floor: the middle ray meets the ball straight on, the other eight the floor.
    EXPECT_EQ(counts.primary, 9u);
    EXPECT_EQ(counts.primary_hits, 9u);
    // The middle ray: reflected up and lost; refracted down through the far side (2), there reflected back up and out, down to the floor (3), whose
    // mirror sends it up into the ball (4) and to its far side (5). A chain: hit 1 at the top: reflected (miss), refracted to the bottom 2: reflected
    // up to the top 3, refracted to the floor 3'. 3: reflected to the bottom 4, refracted out, lost. 4: reflected to the top 5, refracted to the
    // floor 5'. 3': reflected to the bottom 4'. 4': reflected to the floor 5'', refracted to the top 5'''. Eight others: reflected from the floor;
    // the four beside the middle and the four at the corners leave at the angle that they came with, past the ball, and are lost.
    EXPECT_EQ(counts.reflected, 8 + 1 + 1 + 1 + 1 + 1 + 1u);  // of hits 1, 2, 3, 3', 4, 4'
    EXPECT_EQ(counts.reflected_hits, 5u);                     // 3, 4, 4', 5, 5''
    EXPECT_EQ(counts.refracted, 5u);                          // of hits 1, 2, 3, 4, 4'
    EXPECT_EQ(counts.refracted_hits, 4u);                     // 2, 3', 5', 5'''
    // Shadow rays where light falls: eight floor hits (all lit, none in the shadow: its edge is 1/sqrt 8 * 5 = 1.77 away, and the nearest are at
    // 1.763, which is within it), floor hits 3', 5', 5'' under the ball, and the ball's top at 1, 3, 5, 5''' but not its bottom.
    EXPECT_EQ(counts.shadow, 8 + 3 + 4u);
    EXPECT_EQ(counts.inner_shadow, 3u);     // 3, 5, 5''' from inside
    EXPECT_EQ(counts.shadow_hits, 4 + 3u);  // the four nearest, and those under the ball
}
