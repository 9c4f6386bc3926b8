/// The Standard Procedural Databases: rays counted against a second ray tracer and against the published counts.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "scene/formats/format.h"
#include "tests/images/spd_reference.h"
#include "tests/images/spd_teapot.h"
#include "tests/scene/formats/temporary_file.h"
#include "tests/support/probe.h"
#include "tests/support/rendering.h"

namespace {

using namespace brandung;

constexpr uint resolution = 513;

enum Count { PRIMARY, PRIMARY_HITS, SHADOW, SHADOW_HITS, SECONDARY, SECONDARY_HITS, COUNTS };
constexpr const char *count_names[COUNTS] = {"primary rays", "primary hits", "shadow rays", "shadow hits", "secondary rays", "secondary hits"};
using CountArray = std::array<std::uint64_t, COUNTS>;

/// Of data/spd/Readme.txt.
struct ReadmeCounts {
    std::uint64_t primary_hits, reflected, refracted, shadow;
};

struct Published {
    const char *name;
    CountArray havran;  ///< data/spd/EXPECTED.md
    ReadmeCounts readme;
};
void PrintTo(const Published &published, std::ostream *out) { *out << published.name; }

constexpr CountArray teapot_counts = {263169, 161546, 406340, 34757, 226235, 67688};
constexpr ReadmeCounts teapot_readme = {161120, 225248, 0, 407656};

// Both sets of the teapot are of size 12: the readme has 9264 primitives, Havran's grid of one cell per primitive 8932 cells, and he has the primary
// hits of size 12 to the last one, 161,546 (of size 6: 161,449). teapot_s6.nff has 2292 primitives; its coarser facets shade themselves more.
const std::vector<Published> scenes = {
    {"balls_s4", {263169, 263169, 959244, 285178, 179884, 134368}, {263169, 175095, 0, 954368}},
    {"gears_s4", {263169, 245332, 2088012, 1057557, 494338, 365338}, {245086, 304643, 207564, 2246955}},
    {"mount_s6", {263169, 173685, 361037, 74555, 710436, 472351}, {173125, 354769, 354769, 412922}},
    {"rings_s7", {263169, 263169, 1077336, 510719, 312879, 175688}, {263169, 315236, 0, 1085002}},
    {"teapot_s6", teapot_counts, teapot_readme},
    {"teapot_s12", teapot_counts, teapot_readme},
    {"tetra_s6", {263169, 49950, 46262, 5538, 0, 0}, {49788, 0, 0, 46112}},
    {"tree_s11", {263169, 169907, 1110323, 47506, 0, 0}, {169836, 0, 0, 1097419}},
};

/// The scenes that are of the published size.
std::vector<Published> published_scenes() {
    std::vector<Published> result = scenes;
    std::erase_if(result, [](const Published &scene) { return scene.name == std::string("teapot_s6"); });
    return result;
}

// Neither his program nor that of the readme is at hand: its conventions are what a search found. One set yields all of his counts within 0.4 % (but
// mount's shadow hits, -0.84 %), another all of the readme's within 0.5 %. What each of his changes, from the set without it to the whole set:
// * lit as given (rule 10 to the letter): shadow hits of balls +7.4 % to -0.02 %, of teapot +16 % to -0.04 %.
// * start 0.01 (the `hither` of two of the scenes; bodies touch or run into each other, and rays leave through walls thinner than that): secondary
//   hits of balls -5.7 % to -0.07 %, of gears +5.1 % to -0.004 %, of rings +2.3 % to -0.04 %; shadow hits of tree +20 % to -0.13 %.
// * shadow rays against polygons from 0 (so a ray from inside of a gear to a light that its outside faces meets that same polygon): shadow hits of
//   gears -22.6 % to +0.03 %, of mount -1.1 % to -0.8 %.
// * one-sided cones (rule 2 allows it): all counts of rings, from +3.0 % to within 0.04 %; shadow hits of tree +10.5 % to -0.13 %.
// * cones' normals by the ratio of radii (the normal of a cone of height 1, turned but not scaled): tree's shadow rays -1.1 % to +0.005 %, its shadow
//   hits -10.6 % to -0.13 %. Only tree has cones, so this is the weakest; but none of 16 other formulas gave both within 1 % with one-sided cones.
// * rays that the patches' interpolated normals mirror into the body go there: teapot's secondary hits -1.3 % to -0.25 %.
// * refracted rays counted at total reflection: mount's secondary rays -0.38 % to 0 (equal), gears' -1.24 % to -0.002 %.
const spd::Conventions havran{.lit = spd::LitSide::as_given,
                              .one_sided_cones = true,
                              .cone_normals_of_ratio = true,
                              .total_reflection_refracts = true,
                              .shading_normals_lead_inside = true,
                              .start = 0.01,
                              .polygons_shade_from_zero = true};
const spd::Conventions readme{.lit = spd::LitSide::viewer, .total_reflection_refracts = true, .shading_normals_lead_inside = true};

/// Counts of ours that are not within 10 % of Havran's, and stay so: ours are by the readme's conventions, but that light falls on the outside of
/// transparent surfaces, on which it agrees with Havran.
struct Deviation {
    std::string scene;
    Count count;
    std::uint64_t ours, havran;
};
const std::vector<Deviation> deviations = {
    // -20.6 %: his shadow rays from inside of a gear meet the polygon that they start on; ours begin outside. With his conventions +0.03 %.
    {"gears_s4", SHADOW_HITS, 840009, 1057557},
    // +16 %: his patches shade where their interpolated normal faces the light, also behind, and not within 0.01. With his conventions -0.04 %.
    {"teapot_s12", SHADOW_HITS, 40148, 34757},
    // +22 %: besides, his teapot is of size 12.
    {"teapot_s6", SHADOW_HITS, 42393, 34757},
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

class SpdScene : public testing::TestWithParam<Published> {
protected:
    void SetUp() override {
        if (!std::filesystem::exists(data("balls_s4"))) GTEST_SKIP() << "needs " << data("balls_s4") << ": set BRANDUNG_DATA";
    }
    static std::string data(const std::string &name) { return std::string(BRANDUNG_DATA) + "/spd/" + name + ".nff"; }
    static std::string file() {
        if (GetParam().name != std::string("teapot_s12")) return data(GetParam().name);
        static const TemporaryFile teapot(spd::teapot_of_size(data("teapot_s6"), 12), ".nff");
        return teapot.path;
    }

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

TEST_P(SpdScene, CountsAreWithinTenPercentOfThePublishedOnesButForListedDeviations) {
    const Published &published = GetParam();
    const CountArray ours = array_of(rendering().counts);
    EXPECT_EQ(ours[PRIMARY], published.havran[PRIMARY]);
    EXPECT_LE(std::abs(difference(ours[PRIMARY_HITS], published.havran[PRIMARY_HITS])), 0.003);
    for (const Count i : {SHADOW, SHADOW_HITS, SECONDARY, SECONDARY_HITS}) {
        const double measured = difference(ours[i], published.havran[i]);
        SCOPED_TRACE(fmt::format("{}: {}, Havran {} ({:+.2f} %)", count_names[i], ours[i], published.havran[i], 100 * measured));
        const auto listed = std::find_if(deviations.begin(), deviations.end(),
                                         [&](const Deviation &deviation) { return deviation.scene == published.name && deviation.count == i; });
        if (listed == deviations.end()) {
            EXPECT_LE(std::abs(measured), 0.1);
            continue;
        }
        EXPECT_EQ(published.havran[i], listed->havran);
        EXPECT_LE(std::abs(difference(ours[i], listed->ours)), 0.0005);
        EXPECT_GT(std::abs(measured), 0.1) << "no deviation any more";
    }
}

class SpdPublished : public SpdScene {};

/// The reference, which counts what we count (above), counts what was published under the conventions that are said to be theirs.
TEST_P(SpdPublished, HavransConventionsReproduceHavransCounts) {
    const CountArray counts = array_of(reference().count(resolution, resolution, havran));
    for (uint i = 0; i < COUNTS; ++i)
        EXPECT_LE(std::abs(difference(counts[i], GetParam().havran[i])), 0.01)
            << count_names[i] << ": " << counts[i] << ", Havran " << GetParam().havran[i];
}

TEST_P(SpdPublished, TheReadmesConventionsReproduceTheReadmesCounts) {
    const spd::Counts counts = reference().count(resolution, resolution, readme);
    const ReadmeCounts &expected = GetParam().readme;
    EXPECT_LE(std::abs(difference(counts.primary_hits, expected.primary_hits)), 0.01) << counts.primary_hits;
    EXPECT_LE(std::abs(difference(counts.reflected, expected.reflected)), 0.01) << counts.reflected;
    EXPECT_LE(std::abs(difference(counts.refracted, expected.refracted)), 0.01) << counts.refracted;
    EXPECT_LE(std::abs(difference(counts.shadow, expected.shadow)), 0.01) << counts.shadow;
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
    Film film(device, Window{0, 0, resolution, resolution});
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
INSTANTIATE_TEST_SUITE_P(All, SpdPublished, testing::ValuesIn(published_scenes()), [](const auto &info) { return info.param.name; });

/// The file's numbers have six digits, of positions and of unit normals.
TEST(SpdTeapot, OfSizeSixIsTheFileAndOfSizeTwelveHasThePublishedNumberOfPrimitives) {
    const std::string file = std::string(BRANDUNG_DATA) + "/spd/teapot_s6.nff";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "needs " << file << ": set BRANDUNG_DATA";
    std::ifstream given(file);
    std::istringstream made(spd::teapot_of_size(file, 6));
    for (std::string a, b; given >> a;) {
        ASSERT_TRUE(made >> b);
        char *end = nullptr;
        const double number = std::strtod(a.c_str(), &end);
        if (*end != 0) {
            ASSERT_EQ(b, a);
        } else {
            ASSERT_NEAR(std::stod(b), number, 2e-4);
        }
    }
    std::string left;
    EXPECT_FALSE(made >> left);
    std::istringstream fine(spd::teapot_of_size(file, 12));
    unsigned primitives = 0;
    for (std::string word; fine >> word;) primitives += word == "p" || word == "pp";
    EXPECT_EQ(primitives, 9264u);
}

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
    EXPECT_EQ(counts.shadow_hits, 4 + 3u);  // the four nearest, and those under the ball
}
