/// Bundles of rays against paths, of which they are the mean, and against what is known in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "scene/kinds.h"
#include "scene/samplers/sampler.h"
#include "tests/images/irradiance.h"
#include "tests/scene/formats/temporary_file.h"

namespace {

using namespace brandung;
using namespace irradiance;

Bundles bundles_of(uint size) { return {size, size, size, size}; }

void distribute(Scene &scene, Bundles bundles) { scene.integrator.type = "distributed", scene.integrator.bundles = bundles; }

/// What is seen in the middle of the picture, by its material in scene files.
struct Plate {
    const char *name, *material;
};

const std::vector<Plate> plates = {
    {"RoughMetal", R"("type": "conductor", "metal": "gold", "roughness": 0.3)"},
    {"Plastic", R"("type": "plastic", "diffuse": 0.4, "roughness": 0.2)"},
    {"RoughGlass", R"("type": "dielectric", "roughness": 0.4)"},
    {"Glass", R"("type": "dielectric")"},
    {"Sheet", R"("type": "thin_dielectric")"},
    {"Phong", R"("type": "phong", "diffuse": 0.4, "specular": 0.4, "exponent": 30)"},
    {"Whitted", R"("type": "whitted", "diffuse": 0.3, "specular": 0.2, "reflection": 0.3, "transmission": 0.2)"},
    {"Diffuse", R"("type": "diffuse", "reflectance": 0.7)"},
};

/// Spheres of all materials, far below, so that all scenes take the same kernels.
struct AllPlates {
    std::string materials, objects;
};

AllPlates all_plates() {
    AllPlates all;
    for (std::size_t i = 0; i < plates.size(); ++i) {
        const std::string number = std::to_string(i);
        all.materials += R"(, {"name": ")" + number + R"(", )" + plates[i].material + "}";
        all.objects += R"(, {"type": "sphere", "material": ")" + number + R"(", "center": [)" + number + R"(, -90, 0], "radius": 0.4})";
    }
    return all;
}

/// A plate under a lamp and between coloured boards, beneath a sky; numbers are independent, so that the means' errors are known.
Scene plate_scene(const std::string &material) {
    const AllPlates all = all_plates();
    return read_text(R"({"film": {"width": 32, "height": 24, "sampler": "independent"}, "background": [0.3, 0.5, 0.9],
        "integrator": {"type": "path", "max_depth": 4}, "camera": {"from": [0, 1.2, 2], "at": [0, 0.1, 0], "fov": 9},
        "materials": [{"name": "plate", )" +
                     material + R"(}, {"name": "red", "type": "diffuse", "reflectance": [0.8, 0.2, 0.1]},
            {"name": "lamp", "type": "diffuse", "reflectance": 0, "emission": 5})" +
                     all.materials + R"(],
        "objects": [{"type": "sphere", "material": "plate", "center": [0, -2, 0], "radius": 2.1},
            {"type": "polygon", "material": "lamp", "vertices": [[-0.5, 1.6, -1.5], [-0.5, 1.6, -0.7], [0.5, 1.6, -0.7], [0.5, 1.6, -1.5]]},
            {"type": "polygon", "material": "red", "vertices": [[1, -1, 1], [1, -1, -3], [1, 1, -3], [1, 1, 1]]},
            {"type": "polygon", "material": "red", "vertices": [[-1, -3, 3], [-1, -3, -3], [1, -3, -3], [1, -3, 3]]})" +
                     all.objects + "]}");
}

/// Welch's test of the mean of all samples. Sizes differ in two of them, so that none may be taken for another.
void expect_paths_mean(Scene scene) {
    scene.film.spp = 128;
    const Estimate path = estimate(scene);
    EXPECT_LT(path.error(), 0.01L * path.mean) << "the test can tell";
    std::vector<double> p;
    scene.film.seed = 1;
    for (const Bundles &bundles : {bundles_of(1), bundles_of(4), bundles_of(16), bundles_of(64), Bundles{16, 1, 3, 2}, Bundles{1, 16, 12, 9}}) {
        distribute(scene, bundles);
        scene.film.spp = 128 / std::max(bundles.light, bundles.diffuse);
        const Estimate distributed = estimate(scene);
        p.push_back(p_of(distributed, path));
        EXPECT_GT(p.back(), statistics::significance)
            << bundles.light << ", " << bundles.diffuse << ": " << distributed.mean << " instead of " << path.mean;
    }
    EXPECT_TRUE(statistics::plausible(p));
}

class Plates : public testing::TestWithParam<Plate> {};

}  // namespace

TEST_P(Plates, HaveThePathsMeanWhateverTheBundles) { expect_paths_mean(plate_scene(GetParam().material)); }

/// A ball that crosses the picture under a lamp while the shutter is open, over a floor on which its shadow moves.
TEST(Distributed, AMovingBallHasThePathsMeanWhateverTheBundles) {
    expect_paths_mean(read_text(R"({"film": {"width": 32, "height": 24, "sampler": "independent"}, "background": [0.3, 0.5, 0.9],
        "integrator": {"type": "path", "max_depth": 4}, "camera": {"from": [0, 1, 5], "at": [0, 0.4, 0], "fov": 30, "shutter": [0, 1]},
        "materials": [{"name": "ball", "type": "plastic", "diffuse": [0.6, 0.2, 0.1], "roughness": 0.3},
            {"name": "floor", "type": "diffuse", "reflectance": 0.5}, {"name": "lamp", "type": "diffuse", "reflectance": 0, "emission": 5}],
        "groups": [{"name": "ball", "objects": [{"type": "sphere", "material": "ball", "center": [0, 0, 0], "radius": 0.4}]}],
        "objects": [{"type": "polygon", "material": "floor", "vertices": [[-5, 0, 5], [5, 0, 5], [5, 0, -5], [-5, 0, -5]]},
            {"type": "polygon", "material": "lamp", "vertices": [[-0.5, 2, -0.5], [-0.5, 2, 0.5], [0.5, 2, 0.5], [0.5, 2, -0.5]]},
            {"type": "instance", "group": "ball", "transform": [{"time": 0, "transform": {"translate": [-0.8, 0.4, 0]}},
                {"time": 1, "transform": {"translate": [0.8, 0.9, 0.3]}}]}]})"));
}

INSTANTIATE_TEST_SUITE_P(Distributed, Plates, testing::ValuesIn(plates), [](const auto &info) { return std::string(info.param.name); });

namespace {

/// Of all kinds of materials, instances and media, under a lamp, a point light and a sky.
Scene mixed_scene() {
    std::string materials, objects;
    for (std::size_t i = 0; i < plates.size(); ++i) {
        const std::string number = std::to_string(i);
        materials += R"({"name": ")" + number + R"(", )" + plates[i].material + "}, ";
        objects += R"(, {"type": "sphere", "material": ")" + number + R"(", "center": [)" + std::to_string(0.5 * double(i % 3) - 0.5) + ", " +
                   std::to_string(0.5 * double(i / 3) - 0.5) + R"(, 0], "radius": 0.24})";
    }
    return read_text(R"({"film": {"width": 40, "height": 32, "spp": 3}, "background": [0.3, 0.5, 0.9],
        "camera": {"from": [0, 0.4, 4], "at": [0, 0, 0], "fov": 32}, "integrator": {"type": "path", "max_depth": 5},
        "materials": [)" +
                     materials + R"({"name": "lamp", "type": "diffuse", "reflectance": 0, "emission": 5}],
        "lights": [{"type": "point", "position": [1, 2, 3], "intensity": 3}],
        "groups": [{"name": "ball", "objects": [{"type": "sphere", "material": "7", "center": [0, 0, 0], "radius": 1}]}],
        "objects": [{"type": "polygon", "material": "lamp", "vertices": [[-1, 1.6, -1], [-1, 1.6, 0], [1, 1.6, 0], [1, 1.6, -1]]},
            {"type": "instance", "group": "ball", "transform": [{"scale": [3, 0.2, 3]}, {"translate": [0, -1, 0]}]})" +
                     objects + "]}");
}

}  // namespace

TEST(Distributed, BundlesOfOneArePathsBitByBit) {
    for (const SamplerKind &sampler : sampler_kinds()) {
        Scene scene = mixed_scene();
        scene.film.sampler = kind_number(sampler_kinds(), sampler.name);
        const std::uint64_t path = film_hash(render_scene(scene).film);
        distribute(scene, bundles_of(1));
        EXPECT_EQ(film_hash(render_scene(scene).film), path) << sampler.name;
        EXPECT_EQ(film_hash(render_scene(scene, {}, Kinds::all).film), path) << sampler.name << ", with kernels for bundles";
    }
}

TEST(Distributed, BatchesAcceleratorsAndKernelsForEverythingGiveTheSameBits) {
    Scene scene = mixed_scene();
    distribute(scene, {5, 2, 3, 7});
    const std::uint64_t hash = film_hash(render_scene(scene).film);
    for (const uint batch : {50u, 16384u}) EXPECT_EQ(film_hash(render_scene(scene, {.batch = batch}).film), hash) << batch;
    expect_same_bits(scene);
}

/// A bundle has no more rays, and none is lost on the way through levels that are small.
TEST(Distributed, EverySampleSendsItsBundles) {
    Scene scene = plate_scene(R"("type": "diffuse", "reflectance": 0.7)");
    scene.film.spp = 4;
    scene.integrator.max_depth = 1;
    const RayCounts path = render_scene(scene).counts;
    distribute(scene, {5, 3, 1, 1});
    for (const uint batch : {7u, 1000u, 32768u}) {
        const RayCounts counts = render_scene(scene, {.batch = batch}).counts;
        EXPECT_EQ(counts.rays[RAY_CAMERA], path.rays[RAY_CAMERA]);
        EXPECT_EQ(counts.rays[RAY_REFLECTED], path.rays[RAY_REFLECTED] * 3) << batch;
        EXPECT_EQ(counts.rays[RAY_SHADOW], path.rays[RAY_SHADOW] * 5) << batch;
    }
}

TEST(Distributed, AnIdealMirrorSendsOneRay) {
    for (const char *mirror : {R"("type": "conductor", "metal": "gold")", R"("type": "whitted", "diffuse": 0, "reflection": 0.9)"}) {
        Scene scene = plate_scene(mirror);
        scene.integrator.max_depth = 1;
        const RayCounts path = render_scene(scene).counts;
        distribute(scene, bundles_of(16));
        EXPECT_EQ(render_scene(scene).counts.rays[RAY_REFLECTED], path.rays[RAY_REFLECTED]) << mirror;
    }
}

/// In the penumbra of a board that hides half of a lamp. Independent samples: the variance of a sample falls as its bundles grow; of Sobol's points
/// it falls faster. Boxes are shared out over all bundles of a pixel, not within one.
TEST(Distributed, NoiseOfALampsShadowFallsWithTheBundle) {
    Scene scene = scene_seen_at({1, 1.5f, 4}, {0, 0, 0});
    scene.film.spp = 32;
    add_floor(scene), add_quad(scene, 1, {-1, 2, -1}, {2, 0, 0}, {0, 0, 2}), add_quad(scene, 0, {-5, 1, -5}, {5, 0, 0}, {0, 0, 10});
    for (const SamplerKind &sampler : sampler_kinds()) {
        scene.film.sampler = kind_number(sampler_kinds(), sampler.name);
        distribute(scene, bundles_of(1));
        const Real one = estimate(scene).variance;
        for (const uint size : {4u, 16u}) {
            distribute(scene, bundles_of(size));
            const Real ratio = one / estimate(scene).variance / size;
            RecordProperty(std::string(sampler.name) + std::to_string(size), std::to_string(double(ratio)));
            if (std::string(sampler.name) == "independent")
                EXPECT_NEAR(double(ratio), 1, 0.05) << size;
            else
                EXPECT_GT(ratio, std::string(sampler.name) == "stratified" ? 1 : 1.5L) << sampler.name << ' ' << size;
        }
    }
}

namespace {

constexpr float lamp_height = 4, edge_height = 1, lamp_radius = 0.1f;
constexpr uint strip = 64;
constexpr float strip_width = 0.1f;

/// A board that ends at x = 0 between a disk straight above its edge and a floor, of which a strip across the edge's shadow is seen from under the
/// board.
Scene penumbra_scene() {
    Scene scene = read_text(R"({"camera": {"type": "orthographic", "from": [0, 0.5, 0], "at": [0, 0, 0], "up": [0, 0, 1], "height": 0.025}})");
    scene.film.width = strip, scene.film.height = strip / 4, scene.film.spp = 64;
    scene.integrator.max_depth = 1;
    distribute(scene, {64, 1, 1, 1});
    add_material(scene, matte(1)), add_material(scene, emitter(Spectrum(1)));
    add_floor(scene);
    add_quad(scene, 0, {-5, edge_height, -5}, {5, 0, 0}, {0, 0, 10});
    add_disk(scene, 1, {0, lamp_height, 0}, {0, -1, 0}, lamp_radius);
    return scene;
}

/// The part of a disk beyond a line at distance t from its middle, in radii.
double segment(double t) { return t <= -1 ? 1 : t >= 1 ? 0 : (std::acos(t) - t * std::sqrt((1 - t) * (1 + t))) / double(pi); }

/// From the left to the right, where light grows; means of columns, over what the whole disk gives.
std::vector<double> profile_of(const Scene &scene) {
    const std::vector<vec3> picture = render_scene(scene).picture;
    std::vector<double> columns(strip);
    for (uint i = 0; i < picture.size(); ++i) columns[i % strip] += double(picture[i].x) / (picture.size() / strip);
    if (columns.front() > columns.back()) std::reverse(columns.begin(), columns.end());
    const double whole = columns.back();
    for (double &column : columns) column /= whole;
    return columns;
}

/// Sum of squares of a profile against a penumbra of this width about the middle.
double misfit(const std::vector<double> &profile, double width) {
    double sum = 0;
    for (uint i = 0; i < strip; ++i) {
        const double x = ((i + 0.5) / strip - 0.5) * double(strip_width);
        sum += std::pow(profile[i] - segment(-2 * x / width), 2);
    }
    return sum;
}

}  // namespace

/// Similar triangles: as wide as the lamp, times the edge's distance from the floor over its distance from the lamp.
TEST(Distributed, APenumbraIsAsWideAsSimilarTrianglesSay) {
    const double expected = 2 * double(lamp_radius) * double(edge_height) / double(lamp_height - edge_height);
    const std::vector<double> profile = profile_of(penumbra_scene());
    double best = 0;
    for (double width = 0.9 * expected; width < 1.1 * expected; width += 1e-4 * expected)
        if (best == 0 || misfit(profile, width) < misfit(profile, best)) best = width;
    RecordProperty("width", std::to_string(best / expected));
    EXPECT_NEAR(best, expected, 0.01 * expected);
    EXPECT_LT(std::sqrt(misfit(profile, best) / strip), 0.005) << "it is a disk's";
}
