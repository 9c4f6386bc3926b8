/// kernels/cameras, with the records of scene/cameras, against closed forms in double.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "kernels/core/items.h"
#include "tests/support/cameras.h"
#include "tests/support/probe.h"
#include "tests/support/statistics/chi_square.h"
#include "tests/support/statistics/significance.h"

namespace brandung {
namespace {

using glm::dvec2, glm::dvec3, std::numbers::pi;

constexpr uint width = 320, height = 200;

/// By hand from what a description says.
struct Axes {
    dvec3 forward, right, up;
    explicit Axes(const CameraDescription &camera) {
        forward = glm::normalize(dvec3(camera.at) - dvec3(camera.from));
        right = glm::normalize(glm::cross(forward, dvec3(camera.up)));
        up = glm::cross(right, forward);
    }
    dvec3 of(dvec3 v) const { return v.x * right + v.y * up + v.z * forward; }
};

std::vector<vec2> random_pairs(std::size_t count, uint seed) {
    std::mt19937 random(seed);
    std::vector<vec2> pairs(count);
    for (vec2 &pair : pairs) pair.x = float(random() >> 8) * 0x1p-24f, pair.y = float(random() >> 8) * 0x1p-24f;
    return pairs;
}

/// Anywhere in the picture, its corners, its middle, and the middles of its edges.
std::vector<vec2> picture_points() {
    std::vector<vec2> points = random_pairs(20000, 1);
    for (int i = 0; i < 9; ++i) points.push_back({float(i % 3) / 2, float(i / 3) / 2});
    return points;
}

std::vector<Ray> rays_of(const CameraDescription &camera, const std::vector<vec2> &points, const std::vector<vec2> &random) {
    return Probe(std::string("#include \"kernels/cameras/") + camera_kinds()[camera.kind].name + R"(.cl"
        kernel void probe(const global Camera *camera, const global vec2 *points, const global vec2 *random, global Ray *rays) {
            const uint i = get_global_id(0);
            rays[i] = camera_ray(camera->position, camera_view(*camera), points[i].x, points[i].y, random[i]);
        })")
        .run<Ray>(make_camera(camera, width, height), points, random);
}

/// Where picture point (x, y) lies from the middle, in halves of the height, to the right and upwards.
dvec2 from_middle(vec2 point) { return {(2 * double(point.x) - 1) * width / height, 1 - 2 * double(point.y)}; }

struct IdealRay {
    dvec3 origin, direction;
    double slope = 1;  ///< how much the direction turns where its place in the picture moves, over how much others' do
};

/// Every ray against that of `ideal(point)`. Axes and words are rounded once, terms and sums of a direction some times, an angle's sine and cosine
/// have 8e-8: all of that is less than 6e-7 of the longest term, which `largest_term` says for a unit direction.
template <class Ideal> void expect_rays(const CameraDescription &camera, double largest_term, Ideal ideal) {
    const std::vector<vec2> points = picture_points();
    const std::vector<Ray> rays = rays_of(camera, points, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::optional<IdealRay> expected = ideal(points[i]);
        if (!expected) continue;
        ASSERT_NEAR(glm::distance(dvec3(rays[i].direction), expected->direction), 0, 6e-7 * largest_term * expected->slope)
            << points[i].x << ", " << points[i].y;
        ASSERT_NEAR(glm::distance(dvec3(rays[i].origin), expected->origin), 0, 1e-6) << points[i].x << ", " << points[i].y;
        ASSERT_EQ(rays[i].t_max, std::numeric_limits<float>::infinity());
        ASSERT_EQ(RAY_KIND(rays[i].tag), RAY_CAMERA);
        ASSERT_EQ(RAY_SOURCE(rays[i].tag) & MAX_PRIMITIVES, NO_HIT & MAX_PRIMITIVES);
    }
}

}  // namespace

TEST(CameraRays, PerspectiveGoesThroughThePlaneAtDistanceOne) {
    const CameraDescription camera = camera_of_kind("perspective");
    const Axes axes(camera);
    expect_rays(camera, 3, [&](vec2 point) {
        const dvec2 place = from_middle(point) * std::tan(glm::radians(25.0));
        return std::optional(IdealRay{dvec3(camera.from), glm::normalize(axes.of({place, 1}))});
    });
}

TEST(CameraRays, OrthographicOnesAreParallel) {
    const CameraDescription camera = camera_of_kind("orthographic");
    const Axes axes(camera);
    expect_rays(camera, 1, [&](vec2 point) {
        return std::optional(IdealRay{dvec3(camera.from) + axes.of({1.25 * from_middle(point), 0}), axes.forward});
    });
}

TEST(CameraRays, PanoramaHasLongitudesAndLatitudes) {
    CameraDescription camera = camera_of_kind("panorama");
    const Axes axes(camera);
    for (const auto &[horizontal, vertical] : {std::pair(300.0f, 160.0f), {360.0f, 180.0f}, {10.0f, 5.0f}}) {
        camera.horizontal_fov = glm::radians(horizontal), camera.fov = glm::radians(vertical);
        expect_rays(camera, 1, [&](vec2 point) {
            const double longitude = glm::radians(double(horizontal)) * (double(point.x) - 0.5),
                         latitude = glm::radians(double(vertical)) * (0.5 - double(point.y));
            const dvec3 way(std::sin(longitude) * std::cos(latitude), std::sin(latitude), std::cos(longitude) * std::cos(latitude));
            return std::optional(IdealRay{dvec3(camera.from), axes.of(way)});
        });
    }
}

/// Equidistant: the angle to the axis grows as the distance from the middle; equisolid: twice the sine of half that angle does, so that what is seen
/// in a circle has a solid angle as the circle's area.
TEST(CameraRays, FisheyeHasAnglesAsItsMappingSays) {
    CameraDescription camera = camera_of_kind("fisheye");
    const Axes axes(camera);
    for (const bool equisolid : {false, true})
        for (const float degrees : {1.0f, 90.0f, 180.0f, 250.0f, 360.0f}) {
            camera.equisolid = equisolid, camera.fov = glm::radians(degrees);
            const double edge = glm::radians(double(degrees)) / 2;
            expect_rays(camera, 1, [&](vec2 point) -> std::optional<IdealRay> {
                const dvec2 place = from_middle(point);
                const double distance = glm::length(place);
                if (distance > 1) return {};
                const double half = std::asin(distance * std::sin(edge / 2)), angle = equisolid ? 2 * half : distance * edge;
                const dvec2 aside = distance > 0 ? place * (std::sin(angle) / distance) : dvec2(0);
                return IdealRay{dvec3(camera.from), axes.of({aside, std::cos(angle)}), equisolid ? 1 / std::cos(half) : 1};
            });
        }
}

TEST(CameraRays, FisheyeSeesItsCircle) {
    const CameraDescription camera = camera_of_kind("fisheye");
    const std::vector<vec2> points = picture_points();
    const std::vector<uint> seen = Probe(R"(#include "kernels/cameras/fisheye.cl"
        kernel void probe(const global Camera *camera, const global vec2 *points, global uint *seen) {
            const uint i = get_global_id(0);
            store_seen((global uchar *)seen, 4 * i, camera_view(*camera), points[i].x, points[i].y);
        })")
                                       .run<uint>(make_camera(camera, width, height), points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double distance = glm::length(from_middle(points[i]));
        if (std::abs(distance - 1) < 1e-6) continue;
        ASSERT_EQ(seen[i] & 0xff, distance < 1) << distance;
    }
}

/// The lens's points lie across the view, in its circle; what goes through one picture point meets in the sharp plane.
TEST(CameraRays, ThinLensIsSharpInItsPlane) {
    CameraDescription camera = camera_of_kind("thin_lens");
    const Axes axes(camera);
    const std::vector<vec2> points = picture_points(), random = random_pairs(points.size(), 2);
    const auto expect_sharp = [&](double distance) {
        const std::vector<Ray> rays = rays_of(camera, points, random);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const dvec3 offset = dvec3(rays[i].origin) - dvec3(camera.from), direction(rays[i].direction);
            ASSERT_NEAR(glm::dot(offset, axes.forward), 0, 5e-7);
            ASSERT_LE(glm::length(offset), double(camera.lens.radius) + 5e-7);
            const double t = (distance - glm::dot(offset, axes.forward)) / glm::dot(direction, axes.forward);
            const dvec3 sharp = axes.of({from_middle(points[i]) * (distance * std::tan(glm::radians(25.0))), distance});
            ASSERT_NEAR(glm::distance(offset + t * direction, sharp), 0, 5e-6);
            ASSERT_NEAR(glm::length(direction), 1, 3e-7);
        }
    };
    expect_sharp(2.5);
    camera.lens.focus_at = vec3(axes.of({3, -2, 1.5})) + camera.from;
    expect_sharp(1.5);
}

namespace {

using Polygon = std::vector<dvec2>;

/// What of a polygon lies on the side of the line along which dot(normal, p) = offset where that is less (Sutherland & Hodgman, CACM 17(1) 1974).
Polygon clipped(const Polygon &polygon, dvec2 normal, double offset) {
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double da = glm::dot(normal, a) - offset, db = glm::dot(normal, b) - offset;
        if (da <= 0) result.push_back(a);
        if ((da < 0 && db > 0) || (da > 0 && db < 0)) result.push_back(a + (b - a) * (da / (da - db)));
    }
    return result;
}

double area(const Polygon &polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2;
}

struct Aperture {
    uint blades;
    float rotation;  ///< [degrees]
};

/// Points of lenses of radius 1 are counted in squares; areas are those of a polygon cut by them, which for a round lens has 4096 corners.
class LensPoints : public testing::TestWithParam<Aperture> {};

}  // namespace

TEST_P(LensPoints, AreUniformOnTheAperture) {
    constexpr std::size_t count = 1 << 20, cells = 20;
    const auto [blades, rotation] = GetParam();
    CameraDescription camera = camera_of_kind("thin_lens");
    camera.from = {0, 0, 0}, camera.at = {0, 0, -1}, camera.up = {0, 1, 0};
    camera.lens = {.radius = 1, .focus_distance = 2, .blades = blades, .blade_rotation = rotation};
    Polygon aperture;
    const uint corners = blades > 0 ? blades : 4096;
    for (uint k = 0; k < corners; ++k) {
        const double angle = glm::radians(double(rotation)) + 2 * pi * k / corners;
        aperture.emplace_back(std::cos(angle), std::sin(angle));
    }
    std::vector<double> expected;
    for (std::size_t cell = 0; cell < cells * cells; ++cell) {
        const dvec2 low = 2.0 * dvec2(cell % cells, cell / cells) / double(cells) - 1.0, high = low + 2.0 / cells;
        expected.push_back(area(clipped(clipped(clipped(clipped(aperture, {1, 0}, high.x), {-1, 0}, -low.x), {0, 1}, high.y), {0, -1}, -low.y)));
    }
    std::vector<std::uint64_t> counts(cells * cells);
    for (const Ray &ray : rays_of(camera, std::vector<vec2>(count, vec2(0.5f)), random_pairs(count, 3))) {
        ASSERT_EQ(ray.origin.z, 0);
        const auto cell = [](float x) { return std::min(std::size_t(std::max(x + 1, 0.0f) / 2 * cells), cells - 1); };
        ++counts[cell(ray.origin.x) + cells * cell(ray.origin.y)];
    }
    const statistics::ChiSquare test = statistics::chi_square(counts, expected);
    EXPECT_GE(test.degrees, 200);
    EXPECT_TRUE(statistics::plausible(test.p));
}

INSTANTIATE_TEST_SUITE_P(Kernels, LensPoints, testing::Values(Aperture{0, 0}, Aperture{5, 0}, Aperture{5, -40}, Aperture{6, 10}),
                         [](const auto &info) {
                             return std::to_string(info.param.blades) + "BladesTurnedBy" + std::to_string(int(info.param.rotation + 360) % 360);
                         });

TEST(LensPoints, AreThoseOfNumbersAtTheEnds) {
    const std::vector<vec2> ends = {{0, 0}, {0.5f, 0.5f}, {1 - 0x1p-24f, 1 - 0x1p-24f}, {0, 0.5f}, {0.5f, 0}, {1 - 0x1p-24f, 0}};
    for (const uint blades : {0u, 3u, 7u}) {
        CameraDescription camera = camera_of_kind("thin_lens");
        camera.lens.blades = blades;
        for (const Ray &ray : rays_of(camera, ends, ends)) ASSERT_LE(glm::distance(dvec3(ray.origin), dvec3(camera.from)), 0.2 + 5e-7);
    }
}

}  // namespace brandung
