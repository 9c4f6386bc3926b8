#include "tests/kernels/accelerators/hard_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>

#include "tests/support/primitives.h"
#include "tests/support/scenes.h"
#include "tests/support/traced_scene.h"

namespace brandung {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// One of each kind, small: so all scenes but those of spheres alone have one set of programs.
void add_one_of_each_kind(Scene &scene) { add_soup(scene, 0, {.of_each = 1, .size = 0.01f}); }

Scene soup_scene(const Soup &soup) {
    Scene scene = empty_scene();
    add_one_of_each_kind(scene);
    add_soup(scene, 0, soup);
    return scene;
}

Scene spheres_only() {
    Scene scene = empty_scene();
    add_soup(scene, 0, {.counts = {{"sphere", 300}}, .size = 0.3f});
    return scene;
}
Scene one_sphere() {
    Scene scene = empty_scene();
    add_sphere(scene, 0, {0.1f, 0.2f, 0.3f}, 0.7f);
    return scene;
}
Scene mixture() { return soup_scene({.of_each = 150, .size = 0.4f}); }

/// Everything touches planes of the grid with spacing 1/4, where boxes then have their sides.
Scene grid() {
    Scene scene = empty_scene();
    add_one_of_each_kind(scene);
    for (int x = -4; x < 4; ++x)
        for (int y = -4; y < 4; ++y)
            for (int z = -4; z < 4; z += 2) {
                const vec3 p = 0.25f * vec3(x, y, z);
                if ((x + y) % 3 == 0) add_sphere(scene, 0, p + 0.125f, 0.125f);
                if ((x + y) % 3 == 1) add_triangle(scene, 0, p, p + vec3(0.25f, 0, 0), p + vec3(0, 0.25f, 0));
                if ((x + y) % 3 == 2) add_frustum(scene, 0, p + vec3(0.125f, 0.125f, 0), 0.125f, p + vec3(0.125f, 0.125f, 0.25f), 0.125f);
            }
    return scene;
}

/// Far from the origin, where a unit in the last place is 2^-11 of a primitive.
Scene far_away() {
    Scene scene = empty_scene();
    Random random(6);
    const vec3 centre(8192, -8192, 8192);
    for (uint i = 0; i < 100; ++i)
        for (const std::string &kind : names_of_primitive_kinds()) maker_of(kind)(scene, 0, random, centre + random.in_cube(1), 0.3f);
    return scene;
}

/// Cones so flat that rounding moves a crossing by more than they are high: many in planes of two axes, whose boxes are as flat.
Scene flat_rings() {
    Scene scene = empty_scene();
    add_one_of_each_kind(scene);
    Random random(12);
    for (uint i = 0; i < 200; ++i) {
        const vec3 base = random.in_cube(1), way = i % 2 ? random.direction() : vec3(i % 3 == 0, i % 3 == 1, i % 3 == 2);
        add_frustum(scene, 0, base, random.uniform(0, 0.3f), base + way * std::exp2(random.uniform(-18, -12)), random.uniform(0.4f, 0.8f));
    }
    return scene;
}

/// Thin cylinders and cones to a tip: rounding of their quadratic equations takes for hits what passes them by many pads.
Scene hairs() {
    Scene scene = empty_scene();
    add_one_of_each_kind(scene);
    Random random(13);
    for (uint i = 0; i < 300; ++i) {
        const vec3 base = random.in_cube(1), tip = base + random.direction() * random.uniform(0.3f, 1);
        const float radius = std::exp2(random.uniform(-15, -6));
        if (i % 3 == 0) add_frustum(scene, 0, base, random.uniform(0.05f, 0.3f), tip, 0);
        if (i % 3 == 1) add_frustum(scene, 0, base, radius, tip, radius);
        if (i % 3 == 2) add_frustum(scene, 0, base + 0.01f * random.direction(), radius, base + vec3(0, 1, 0), radius);  // side by side
    }
    return scene;
}

/// Disks that touch or overlap in planes of two axes, whose boxes are flat, and in one askew plane, where rounding decides which is met first.
Scene disks_in_planes() {
    Scene scene = empty_scene();
    add_one_of_each_kind(scene);
    Random random(14);
    const vec3 askew = random.direction();
    for (uint i = 0; i < 300; ++i) {
        const vec3 p = 0.25f * glm::round(4.0f * random.in_cube(1)), axis(i % 4 == 0, i % 4 == 1, i % 4 == 2);
        if (i % 4 < 3) add_disk(scene, 0, p, i % 8 < 4 ? axis : -axis, 0.125f * float(1 + random.below(3)));
        if (i % 4 == 3) add_disk(scene, 0, p - askew * glm::dot(askew, p), askew, random.uniform(0.1f, 0.5f));
    }
    return scene;
}

constexpr vec3 eye(0, 0, 3);  // from the centre

/// Nearly edge on as seen from the eye: there t is worst conditioned.
Scene edge_on() {
    Scene scene = empty_scene();
    add_one_of_each_kind(scene);
    Random random(9);
    for (uint i = 0; i < 300; ++i) {
        const vec3 a = random.in_cube(1), away = glm::normalize(a - eye);
        const float thin = std::exp2(random.uniform(-20, -6));
        const vec3 b = a + 0.5f * away + random.in_cube(thin), c = a + 0.3f * away + random.in_cube(thin);
        if (i % 3 == 0) add_triangle(scene, 0, a, b, c);
        if (i % 3 == 1) add_smooth_triangle(scene, 0, a, b, c, vec3(0));
        if (i % 3 == 2) add_frustum(scene, 0, a, thin, b, 2 * thin);
        if (i % 3 == 0) add_disk(scene, 0, a, glm::cross(away, random.direction()) + thin * random.direction(), random.uniform(0.05f, 0.3f));
    }
    return scene;
}

/// Groups of every kind, of sizes from 1e-3 to 1e3, brought to about 1 by instances: turned, stretched, mirrored; every fourth instance twice.
Scene instances() {
    Scene scene = empty_scene();
    add_soup(scene, 0, {.of_each = 5, .size = 0.4f});
    Random random(11);
    for (const float size : {1e-3f, 1.0f, 1e3f}) {
        Scene group = empty_scene();
        for (uint i = 0; i < 10; ++i)
            for (const std::string &kind : names_of_primitive_kinds()) maker_of(kind)(group, 0, random, size * random.in_cube(1), 0.5f * size);
        add_group(scene, "", std::move(group.shapes));
    }
    for (uint i = 0; i < 48; ++i) {
        const uint group = i % 3;
        const float size = group == 0 ? 1e-3f : group == 1 ? 1.0f : 1e3f;
        glm::dvec3 factors;
        for (int axis = 0; axis < 3; ++axis) factors[axis] = std::exp2(random.uniform(-3, -1)) / size * (random.below(2) ? 1 : -1);
        AffineMap map = scaling(factors);
        if (i % 5 != 0)
            map = then(rotation(random.uniform(-180, 180), random.direction()), then(map, rotation(random.uniform(0, 360), random.direction())));
        map = then(map, translation(random.in_cube(1)));
        for (uint copy = 0; copy < (i % 4 == 0 ? 2u : 1u); ++copy) EXPECT_FALSE(add_instance(scene, group, map));
    }
    return scene;
}

/// Small triangles in layers, every other one sheared flat by its instance: the rounding of a ray that comes from afar is then some 100 times
/// larger than the boxes are grown, so that hits lie before the boxes that they are in, and before other layers.
Scene sheared_layers() {
    Scene scene = empty_scene();
    add_soup(scene, 0, {.of_each = 1, .size = 0.01f});
    const float shear = 1e5f, size = 0.05f;
    Scene group = empty_scene();
    add_triangle(group, 0, {-size, -size, shear * size}, {size, -size, -shear * size}, {0, size, 0});
    add_group(scene, "", std::move(group.shapes));
    for (uint layer = 0; layer < 20; ++layer) {
        const float z = 0.002f * float(layer);
        const AffineMap map{{{1, 0, shear}, {0, 1, 0}, {0, 0, 1}}, {0, 0, z}};
        if (layer % 2) {
            add_triangle(scene, 0, {-size, -size, z}, {size, -size, z}, {0, size, z});
        } else {
            EXPECT_FALSE(add_instance(scene, 0, map));
        }
    }
    return scene;
}

std::vector<Bounds> boxes_of(const Scene &scene) {
    std::vector<Bounds> boxes;
    for (const auto &shape : scene.shapes)
        for (std::size_t i = 0; i < shape->count(); ++i) boxes.push_back(shape->bounds(i));
    for (const PlacedGroup &instance : scene.instances) boxes.push_back(instance.bounds);
    return boxes;
}

vec3 axis(uint i, float sign) {
    vec3 d(std::copysign(0.0f, sign));
    d[int(i)] = sign;
    return d;
}

}  // namespace

void PrintTo(const SceneKind &kind, std::ostream *out) { *out << kind.name; }

std::vector<SceneKind> scene_kinds() {
    std::vector<SceneKind> kinds = {
        {"spheres_only", spheres_only, {}},
        {"one_sphere", one_sphere, {}},
        {"mixture", mixture, {}},
        {"duplicates", duplicates, {}},
        {"grid", grid, {}},
        {"disks_in_planes", disks_in_planes, {}},
        {"edge_on", edge_on, {}},
        {"far_away", far_away, {8192, -8192, 8192}},
        {"flat_rings", flat_rings, {}},
        {"hairs", hairs, {}},
        {"instances", instances, {}},
        {"sheared_layers", sheared_layers, {3, 0, 0}},
    };
    for (const std::string &name : names_of_primitive_kinds())
        kinds.push_back({"only_" + name, [name] { return soup_scene({.counts = {{name, 400}}, .size = 0.4f}); }, {}});
    return kinds;
}

Scene duplicates() {
    Scene scene = empty_scene();
    add_one_of_each_kind(scene);
    for (uint copy = 0; copy < 3; ++copy) {
        Random random(5);
        for (uint i = 0; i < 60; ++i) {
            const vec3 a = random.in_cube(1), b = a + random.in_cube(0.5f), c = a + random.in_cube(0.5f);
            add_triangle(scene, 0, a, b, c);
            add_smooth_triangle(scene, 0, a, b, c, a - b);
            for (const std::string &kind : names_of_primitive_kinds())
                if (kind != "triangle" && kind != "smooth_triangle") maker_of(kind)(scene, 0, random, a, 0.2f);
        }
    }
    return scene;
}

std::vector<Ray> make_rays(const Scene &scene, vec3 centre) {
    Random random(7);
    std::vector<Ray> rays;
    const auto t_max = [&] { return random.below(4) == 0 ? random.uniform(0, 2) : infinity; };
    const std::vector<Bounds> boxes = boxes_of(scene);
    const auto box = [&]() -> const Bounds & { return boxes[random.below(uint(boxes.size()))]; };
    for (uint i = 0; i < 32768; ++i) rays.push_back(make_ray(centre + random.in_cube(2), random.direction(), t_max()));
    // From one point, in neighbouring directions, as camera rays are.
    for (uint i = 0; i < 4096; ++i) {
        const vec3 direction(0.02f * float(i % 64) - 0.63f, 0.02f * float(i / 64) - 0.63f, -1);
        rays.push_back(make_ray(centre + eye, vec3(glm::normalize(glm::dvec3(direction)))));
    }
    // From the eye into the boxes.
    for (uint i = 0; i < 16384; ++i) {
        const Bounds &b = box();
        const glm::dvec3 p(random.uniform(b.low.x, b.high.x), random.uniform(b.low.y, b.high.y), random.uniform(b.low.z, b.high.z));
        rays.push_back(make_ray(centre + eye, vec3(glm::normalize(p - glm::dvec3(centre + eye))), t_max()));
    }
    // At places of things themselves, which thin ones have few of in their boxes, or just beside.
    std::vector<Hull> hulls;
    for (const auto &shape : scene.shapes)
        for (std::size_t i = 0; i < shape->count(); ++i) hulls.push_back(shape->hull(i));
    for (uint i = 0; i < 16384 && !hulls.empty(); ++i) {
        const Hull &hull = hulls[random.below(uint(hulls.size()))];
        const HullPart &a = hull.parts[random.below(hull.count)], &b = hull.parts[random.below(hull.count)];
        const float u = random.uniform(0, 1), radius = (1 - u) * a.radius + u * b.radius;
        const vec3 p = (1 - u) * a.center + u * b.center + random.uniform(0.9f, 1.1f) * radius * random.direction();
        const vec3 from = random.below(2) ? centre + eye : p + 3.0f * random.direction();
        rays.push_back(make_ray(from, vec3(glm::normalize(glm::dvec3(p) - glm::dvec3(from))), t_max()));
    }
    // Any length of the direction.
    for (uint i = 0; i < 1024; ++i)
        rays.push_back(make_ray(centre + random.in_cube(2), random.direction() * std::exp2(random.uniform(-10, 10)), t_max()));
    // Along the axes, from anywhere.
    for (uint i = 0; i < 2048; ++i)
        rays.push_back(make_ray(centre + random.in_cube(2), axis(random.below(3), random.below(2) ? 1.0f : -1.0f), t_max()));
    // In a plane of a box: along an axis or askew.
    for (uint i = 0; i < 4096; ++i) {
        const Bounds &b = box();
        const int a = int(random.below(3));
        vec3 origin = centre + random.in_cube(2), direction = random.below(2) ? axis(uint(a + 1) % 3, 1) : random.direction();
        origin[a] = random.below(2) ? b.low[a] : b.high[a];
        direction[a] = random.below(2) ? 0.0f : -0.0f;
        rays.push_back(make_ray(origin, direction, t_max()));
    }
    // Through corners of boxes, and from them, along edges too.
    for (uint i = 0; i < 4096; ++i) {
        const Bounds &b = box();
        const vec3 corner(random.below(2) ? b.low.x : b.high.x, random.below(2) ? b.low.y : b.high.y, random.below(2) ? b.low.z : b.high.z);
        const vec3 direction = random.below(2) ? random.direction() : axis(random.below(3), -1);
        rays.push_back(make_ray(random.below(2) ? corner : corner - 2.0f * direction, direction, t_max()));
    }
    return rays;
}

}  // namespace brandung
