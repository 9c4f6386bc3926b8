/// kernels/primitives/smooth_triangle.cl: normals between those of the vertices.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/scenes.h"
#include "tests/support/traced_scene.h"

namespace brandung {
namespace {

using glm::dvec3;

/// Weights of a, b and c at a point of their plane: areas of the triangles opposite to them.
dvec3 weights_at(const vec3 *corners, dvec3 p) {
    const dvec3 a(corners[0]), b(corners[1]), c(corners[2]), n = glm::cross(b - a, c - a);
    const double whole = glm::dot(n, n);
    return {glm::dot(glm::cross(c - b, p - b), n) / whole, glm::dot(glm::cross(a - c, p - c), n) / whole,
            glm::dot(glm::cross(b - a, p - a), n) / whole};
}

/// Three different normals: their mean with the weights of the point, made unit length, on the side where the vertices are counterclockwise.
TEST(SmoothTriangle, TheNormalIsInterpolatedBetweenTheVertices) {
    const vec3 corners[] = {{-1, -1, 0.2f}, {2, -0.5f, 0}, {0.3f, 1.5f, -0.4f}};
    const vec3 normals[] = {vec3(glm::normalize(dvec3(-0.5, 0, 1))), vec3(glm::normalize(dvec3(0.8, 0.1, 1))), vec3(0, 0, 1)};
    for (const float side : {1.0f, -1.0f}) {  // of normals, which count as lines
        Scene scene;
        add_material(scene, matte(0.5f));
        add_triangle_mesh(
            scene, 0,
            MeshData{
                .positions = {corners, corners + 3}, .normals = {side * normals[0], side * normals[1], side * normals[2]}, .indices = {0, 1, 2}});
        TracedScene traced(scene, "none");
        Random random(1);
        std::vector<Ray> rays;
        for (uint i = 0; i < 4096; ++i) {
            const vec3 origin = 4.0f * random.direction();
            rays.push_back(make_ray(origin, vec3(glm::normalize(dvec3(random.in_cube(1)) - dvec3(origin)))));
        }
        const std::vector<Hit> hits = traced.closest_hits(rays);
        const std::vector<Surface> surfaces = traced.surfaces(rays, hits);
        uint compared = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (hits[i].primitive == NO_HIT) continue;
            ++compared;
            const dvec3 w = weights_at(corners, dvec3(surfaces[i].p));
            const dvec3 n = glm::normalize(w.x * dvec3(normals[0]) + w.y * dvec3(normals[1]) + w.z * dvec3(normals[2]));
            // With u = 2^-24: the point is off by less than 8 u in all, and so a weight by 4 u, since heights of the triangle are more than 2;
            // normals of vertices differ by less than 1.3. The mean's own rounding is 3 u, and unit length takes 3 u more.
            ASSERT_LT(glm::length(dvec3(surfaces[i].normal) - n), 16 * 0x1p-24) << w.x << " " << w.y << " " << w.z;
        }
        EXPECT_GT(compared, 500u);
    }
}

/// A face of a ball with the ball's normals: from outside it is lifted to the ball or beyond, by no more than it lay below, from inside not at all.
TEST(SmoothTriangle, IsLiftedBeyondTheBallThatItsNormalsAreOf) {
    const auto on_ball = [](double x, double y) { return vec3(glm::normalize(dvec3(x, y, 1))); };
    const std::vector<vec3> corners = {on_ball(-0.15, -0.1), on_ball(0.2, -0.05), on_ball(0.03, 0.2)};
    Scene scene;
    add_material(scene, matte(0.5f));
    add_triangle_mesh(scene, 0, MeshData{.positions = corners, .normals = corners, .indices = {0, 1, 2}});
    TracedScene traced(scene, "none");
    Random random(1);
    std::vector<Ray> rays;
    for (uint i = 0; i < 4096; ++i) {
        const vec3 target = vec3(0.2f * random.in_cube(1).x, 0.2f * random.in_cube(1).y, 1), origin(0, 0, i % 2 ? 5 : 0);
        rays.push_back(make_ray(origin, vec3(glm::normalize(dvec3(target) - dvec3(origin)))));
    }
    const std::vector<Hit> hits = traced.closest_hits(rays);
    const std::vector<Surface> surfaces = traced.surfaces(rays, hits);
    uint outside = 0, inside = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (hits[i].primitive == NO_HIT) continue;
        const double below = 1 - glm::length(dvec3(surfaces[i].p)), above = glm::length(dvec3(surfaces[i].p) + dvec3(surfaces[i].lift)) - 1;
        if (i % 2) {
            ++outside;
            ASSERT_GT(above, -1e-6) << below;
            ASSERT_LT(above, below + 1e-6);
        } else {
            ++inside;
            ASSERT_EQ(surfaces[i].lift, vec3(0));
        }
    }
    EXPECT_GT(outside, 200u);
    EXPECT_GT(inside, 200u);
}

}  // namespace
}  // namespace brandung
