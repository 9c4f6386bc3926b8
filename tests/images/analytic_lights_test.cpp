/// Lamps of integrator path to a tenth of a percent: irradiances that are known in closed form lie in simultaneous confidence intervals.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "scene/kinds.h"
#include "scene/samplers/sampler.h"
#include "tests/images/irradiance.h"

namespace {

using namespace brandung;
using namespace irradiance;
using oracle::Vec;

/// Where the floor is lit: three by three points.
std::vector<vec3> places() {
    std::vector<vec3> all;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) all.push_back({-1.2f + 1.1f * float(i), 0, -1 + 0.8f * float(j)});
    return all;
}

/// Lambert (Photometria, 1760): the vector sum over edges of the angle under which each is seen times the normal of the plane through it and the
/// point, its part along the floor's normal, over 2 pi. For polygons above the floor, of corners that go round counterclockwise as seen from there.
Real polygon_factor(const std::vector<vec3> &corners, vec3 place) {
    Real sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec a = Vec(corners[i]) - Vec(place), b = Vec(corners[(i + 1) % corners.size()]) - Vec(place), across = glm::cross(a, b);
        const Real length = glm::length(across), angle = std::atan2(length, glm::dot(a, b));
        sum += angle * across.y / length;
    }
    return std::abs(sum) / (2 * pi);
}

/// To a parallel disk of this radius, at this height and so far aside (Howell, C-9).
Real disk_factor(Real radius, Real height, Real aside) {
    if (aside == 0) return radius * radius / (height * height + radius * radius);
    const Real h = height / aside, r = radius / aside, z = 1 + h * h + r * r;
    return (1 - (1 + h * h - r * r) / std::sqrt(z * z - 4 * r * r)) / 2;
}

struct Analytic {
    const char *name;
    std::function<void(Scene &scene)> add;
    std::function<Real(vec3 place)> factor;
};

const std::vector<vec3> pentagon = {{-1, 1, -0.5f}, {0.2f, 1.3f, -1.2f}, {1.2f, 1.6f, -0.2f}, {0.6f, 1.5f, 1}, {-0.8f, 1.1f, 0.6f}};

/// What corners in one plane should be, to floats: heights are put onto the plane of the first three.
std::vector<vec3> flattened(std::vector<vec3> corners) {
    const glm::dvec3 a(corners[0]), n = glm::cross(glm::dvec3(corners[1]) - a, glm::dvec3(corners[2]) - a);
    for (vec3 &corner : corners) corner.y = float(a.y - (n.x * (corner.x - a.x) + n.z * (corner.z - a.z)) / n.y);
    return corners;
}

void add_polygon(Scene &scene, const std::vector<vec3> &corners) {
    MeshData mesh;
    append_polygon(scene, mesh, corners, {});
    add_triangle_mesh(scene, 1, std::move(mesh));
}

const std::vector<vec3> quad = {{-1, 2, -1}, {-1, 2, 1}, {1, 2, 1}, {1, 2, -1}};

const vec3 tilted_center(0.2f, 1.5f, 0.1f), tilted_normal(0.3f, -1, 0.2f);

/// Corners of a polygon that all but has a disk's area.
std::vector<vec3> rim(vec3 center, vec3 normal, Real radius) {
    constexpr int corners = 2048;
    const glm::dvec3 n = glm::normalize(glm::dvec3(normal)), x = glm::normalize(glm::cross(n, glm::dvec3(1, 0, 0))), y = glm::cross(n, x);
    const double step = 2 * double(pi) / corners, reach = double(radius) * std::sqrt(step / std::sin(step));
    std::vector<vec3> points;
    for (int i = 0; i < corners; ++i) points.push_back(vec3(glm::dvec3(center) + reach * (std::cos(i * step) * x + std::sin(i * step) * y)));
    return points;
}

/// From a point beyond its tip a cone is a disk with its rim, however high it is: all of it faces the point.
const std::vector<Analytic> lamps = {
    {"Quad", [](Scene &scene) { add_polygon(scene, quad); }, [](vec3 place) { return polygon_factor(quad, place); }},
    {"Pentagon", [](Scene &scene) { add_polygon(scene, flattened(pentagon)); },
     [](vec3 place) { return polygon_factor(flattened(pentagon), place); }},
    {"Disk",
     [](Scene &scene) {
         add_disk(scene, 1, {-0.1f, 1.2f, 0.3f}, {0, -1, 0}, 0.9f);
     },
     [](vec3 place) { return disk_factor(0.9L, 1.2L, std::hypot(Real(place.x) + 0.1L, Real(place.z) - 0.3L)); }},
    {"TiltedDisk", [](Scene &scene) { add_disk(scene, 1, tilted_center, tilted_normal, 0.8f); },
     [](vec3 place) { return polygon_factor(rim(tilted_center, tilted_normal, 0.8L), place); }},
    {"Cone",
     [](Scene &scene) {
         add_frustum(scene, 1, {0.2f, 1.5f, 0.1f}, 0.8f, {0.2f, 1.3f, 0.1f}, 0);
     },
     [](vec3 place) { return disk_factor(0.8L, 1.5L, std::hypot(Real(place.x) - 0.2L, Real(place.z) - 0.1L)); }},
    {"Sphere",
     [](Scene &scene) {
         add_sphere(scene, 1, {0.3f, 1.8f, 0.2f}, 0.9f);
     },
     [](vec3 place) {
         const Vec d = Vec(0.3f, 1.8f, 0.2f) - Vec(place);
         const Real square = glm::dot(d, d);
         return Real(0.9f) * 0.9f / square * d.y / std::sqrt(square);
     }},
};

/// A floor under a sphere of radius 1000 that hides all of its sky; the lowest point of the sphere is at y = 0.
Scene scene_under_large_sphere(float gap) {
    const vec3 place(0, -gap, 0);
    Scene scene = scene_seen_at(place + vec3(0.5f, 0.5f, 0.2f) * gap, place);
    scene.integrator.type = "path";
    scene.film.sampler = kind_number(sampler_kinds(), "independent");
    scene.film.width = 64, scene.film.height = 64, scene.film.spp = 256;
    add_quad(scene, 0, {-0.5f, -gap, 0.5f}, {1, 0, 0}, {0, 0, -1});
    add_sphere(scene, 1, {0, 1000, 0}, 1000);
    return scene;
}

class LargeSphere : public testing::TestWithParam<float> {};

class AnalyticLights : public testing::TestWithParam<Analytic> {};

}  // namespace

/// Two formulas that know nothing of each other.
TEST(AnalyticLightsThemselves, AgreeOnASquare) {
    for (const vec3 place : places()) EXPECT_NEAR(double(polygon_factor(quad, place) / square_factor(place.x, place.z)), 1, 1e-12);
}

/// Intervals of all places under all lamps together hold the truth with 95 % (Šidák 1967), and reach no further than a thousandth of it.
TEST_P(AnalyticLights, AreRightToAThousandth) {
    const std::vector<vec3> all = places();
    for (const vec3 place : all) {
        Scene scene = scene_seen_at(place + vec3(4, 0.4f, 0.5f), place);
        scene.integrator.type = "path";
        scene.film.sampler = kind_number(sampler_kinds(), "independent");
        scene.film.width = 64, scene.film.height = 64, scene.film.spp = 2048;
        GetParam().add(scene);
        add_floor(scene);
        SCOPED_TRACE(testing::Message() << place.x << ", " << place.z);
        expect_right_to_a_thousandth(estimate(scene), GetParam().factor(place), all.size() * lamps.size());
    }
}

/// However close its surface is: in the last case distance and radius are the same float. There points that are asked are nearer to the floor than
/// their own rounding, 2^-21 of 2000, and send nothing, which leaves out of what they share with rays that meet them up to 1e-4 of all.
TEST_P(LargeSphere, IsAllOfTheSky) {
    const Real d = 1000 + Real(GetParam());
    const Estimate sky = estimate(scene_under_large_sphere(GetParam()));
    EXPECT_NEAR(double(sky.mean), double(1e6L / (d * d)), 1e-4 + 3 * double(sky.error()));
    EXPECT_LT(sky.error(), 1e-4L) << "the test can tell";
}

INSTANTIATE_TEST_SUITE_P(Path, LargeSphere, testing::Values(0.1f, 0.003f, 1e-5f),
                         [](const auto &info) { return "Gap" + std::to_string(info.index); });
INSTANTIATE_TEST_SUITE_P(Path, AnalyticLights, testing::ValuesIn(lamps), [](const auto &info) { return std::string(info.param.name); });
