#include "tools/bench/traversal_rays.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "runtime/accelerators/traversals.h"
#include "runtime/wavefront/work.h"

namespace brandung {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

glm::dvec3 point_in_world(const Transform &m, glm::dvec3 p) {
    return glm::dvec3(m.x) * p.x + glm::dvec3(m.y) * p.y + glm::dvec3(m.z) * p.z + glm::dvec3(m.origin);
}

/// Where a ray has hit something.
struct SurfacePlace {
    vec3 origin;        ///< of rays that leave it on the side that they have come from
    glm::dvec3 normal;  ///< to that side, unit length
};

/// Of the surface's point, in double, put off the surface by more than its rounding to float, and that of a tracer which looks for the surface.
vec3 origin_off(glm::dvec3 p, glm::dvec3 normal, double error) {
    const double off = error * (std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z));
    return vec3(p + off * normal);
}

/// A triangle's plane is known to its tracers to the rounding of its corners' coordinates.
SurfacePlace place_on(const GeometryPrimitive &primitive, const Transform *to_world, const Ray &ray, float t) {
    const auto in_world = [&](glm::dvec3 p) { return to_world ? point_in_world(*to_world, p) : p; };
    const glm::dvec3 from(ray.origin), way(ray.direction), a = in_world(primitive.a);
    glm::dvec3 p = from + double(t) * way, normal;
    if (primitive.kind == GeometryPrimitive::Kind::triangle) {
        const glm::dvec3 b = in_world(primitive.b), c = in_world(primitive.c);
        normal = glm::normalize(glm::cross(b - a, c - a));
        p -= glm::dot(p - a, normal) * normal;
    } else {
        normal = glm::normalize(p - a);
    }
    if (glm::dot(normal, way) > 0) normal = -normal;
    const double largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return {origin_off(p, normal, 0x1p-20 * largest), normal};
}

/// Same bits everywhere: a mixer of 64 bits (splitmix64's), one stream per set.
double random_unit(std::uint64_t stream, std::uint64_t i) {
    std::uint64_t x = (stream << 48) + (i + 1) * 0x9e3779b97f4a7c15u;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return static_cast<double>((x ^ x >> 31) >> 11) * 0x1p-53;
}

/// Above the surface, by the cosine.
glm::dvec3 cosine_direction(glm::dvec3 normal, double u, double v) {
    const glm::dvec3 aside = std::abs(normal.x) > 0.5 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(aside, normal)), y = glm::cross(normal, x);
    const double radius = std::sqrt(u), angle = 2 * std::numbers::pi * v;
    return glm::normalize(radius * std::cos(angle) * x + radius * std::sin(angle) * y + std::sqrt(1 - u) * normal);
}

class RayMaker {
public:
    RayMaker(const SceneGeometry &geometry, vec3 light, const FindHits &find_hits) : geometry_(geometry), light_(light), find_hits_(find_hits) {}

    RayQueue camera_rays(const Camera &camera) const {
        const std::vector<uint> pixels = PixelOrder(Window{0, 0, camera.width, camera.height}).next(std::size_t{camera.width} * camera.height);
        return queue(RayQueue::Use::camera, false, 0, pixels.size(), [&](std::size_t i) -> std::optional<Ray> {
            const double x = ((pixels[i] & 0xffff) + 0.5) / camera.width, y = ((pixels[i] >> 16) + 0.5) / camera.height;
            const glm::dvec3 way = glm::dvec3(camera.corner) + x * glm::dvec3(camera.right) + y * glm::dvec3(camera.down);
            return Ray{camera.position, infinity, vec3(glm::normalize(way)), RAY_TAG(RAY_CAMERA, NO_HIT)};
        });
    }

    RayQueue bounces(const RayQueue &from, uint generation) const {
        return leaving(from, RayQueue::Use::secondary, false, generation, [&](const SurfacePlace &place, std::size_t i) {
            const glm::dvec3 way = cosine_direction(place.normal, random_unit(generation, 2 * i), random_unit(generation, 2 * i + 1));
            return Ray{place.origin, infinity, vec3(way), RAY_TAG(RAY_REFLECTED, NO_HIT)};
        });
    }

    RayQueue shadows(const RayQueue &from) const {
        return leaving(from, RayQueue::Use::shadow, true, 0, [&](const SurfacePlace &place, std::size_t) -> std::optional<Ray> {
            const glm::dvec3 way = glm::dvec3(light_) - glm::dvec3(place.origin);
            const double distance = glm::length(way);
            if (glm::dot(way, place.normal) <= 0) return {};
            return Ray{place.origin, static_cast<float>(0.999 * distance), vec3(way / distance), RAY_TAG(RAY_SHADOW, NO_HIT)};
        });
    }

private:
    template <class Leave> RayQueue leaving(const RayQueue &from, RayQueue::Use use, bool shadow, uint generation, Leave leave) const {
        const RayAnswers found = find_hits_(from);
        return queue(use, shadow, generation, from.count(), [&](std::size_t i) -> std::optional<Ray> {
            const Hit &hit = found.hits[i];
            if (hit.primitive == NO_HIT) return {};
            const uint instance = found.instances[i];
            const Transform *to_world = instance == 0 ? nullptr : &geometry_.instances[instance].to_world;
            return leave(place_on(geometry_.primitives[hit.primitive], to_world, from.rays[i], hit.t), i);
        });
    }

    /// Of what `make` gives for 0 ... count - 1, in this order.
    template <class Make> RayQueue queue(RayQueue::Use use, bool shadow, uint generation, std::size_t count, Make make) const {
        std::vector<std::optional<Ray>> rays(count);
        tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { rays[i] = make(i); });
        RayQueue queue{use, shadow, shadow ? are_shadow_rays_coherent(generation) : are_coherent(generation), {}, {}};
        for (const std::optional<Ray> &ray : rays)
            if (ray) queue.rays.push_back(*ray);
        queue.sources.resize(queue.rays.size());
        return queue;
    }

    const SceneGeometry &geometry_;
    vec3 light_;
    const FindHits &find_hits_;
};

/// The same rays, but for the question.
RayQueue asking_for_any(RayQueue queue) {
    queue.use = RayQueue::Use::shadow, queue.shadow = true, queue.coherent = are_shadow_rays_coherent(0);
    for (Ray &ray : queue.rays) ray.tag = RAY_TAG(RAY_SHADOW, NO_HIT);
    return queue;
}

}  // namespace

const std::vector<std::string> &ray_set_names() {
    static const std::vector<std::string> names = {"camera", "diffuse", "diffuse2", "shadow", "any"};
    return names;
}

std::vector<RaySet> make_ray_sets(const std::vector<std::string> &names, const Camera &camera, vec3 light, const SceneGeometry &geometry,
                                  const FindHits &find_hits) {
    const RayMaker maker(geometry, light, find_hits);
    const RayQueue camera_rays = maker.camera_rays(camera), diffuse = maker.bounces(camera_rays, 1);
    std::vector<RaySet> sets;
    for (const std::string &name : ray_set_names()) {
        if (std::ranges::find(names, name) == names.end()) continue;
        if (name == "camera") sets.push_back({name, camera_rays});
        if (name == "diffuse") sets.push_back({name, diffuse});
        if (name == "diffuse2") sets.push_back({name, maker.bounces(diffuse, 2)});
        if (name == "shadow") sets.push_back({name, maker.shadows(camera_rays)});
        if (name == "any") sets.push_back({name, asking_for_any(diffuse)});
    }
    return sets;
}

}  // namespace brandung
