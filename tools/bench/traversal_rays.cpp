#include "tools/bench/traversal_rays.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <optional>

#include "kernels/cameras/perspective.h"
#include "runtime/wavefront/work.h"
#include "scene/kinds.h"
#include "scene/lights/light.h"

namespace brandung {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

using glm::dvec3;

/// A map of points, with the magnitudes of its linear part's numbers.
struct PlaceMap {
    explicit PlaceMap(const Transform &m) : linear(dvec3(m.x), dvec3(m.y), dvec3(m.z)), origin(m.origin) {
        for (int axis = 0; axis < 3; ++axis) sizes[axis] = glm::abs(linear[axis]);
    }
    dvec3 point(dvec3 p) const { return linear * p + origin; }
    glm::dmat3 linear, sizes;
    dvec3 origin;
};

/// Where rays that leave a surface begin, on the side that a ray has come from.
struct SurfacePlace {
    dvec3 point;
    dvec3 error;   ///< of tracers that look for the surface there
    dvec3 normal;  ///< to that side, unit length
    vec3 origin() const { return vec3(point + glm::dot(glm::abs(normal), error) * normal); }
};

dvec3 rounded(Vector v) { return {double(v.x), double(v.y), double(v.z)}; }

/// From near its surface: the second step is for what is curved.
SurfacePlace place_on_other(const OtherPrimitives &primitives, uint lane, dvec3 hit) {
    Vector point(hit.x, hit.y, hit.z);
    for (int step = 0; step < 2; ++step)
        point = point - primitives.oracle->normal_at(primitives[lane], point).n * primitives.oracle->distance(primitives[lane], point);
    return {rounded(point), {}, rounded(primitives.oracle->normal_at(primitives[lane], point).n)};
}

/// In double, on the primitive itself. Tracers know it to some units in the last place of coordinates.
SurfacePlace place_on(const SceneGeometry &geometry, const GeometryPrimitive &primitive, dvec3 hit) {
    const dvec3 a(primitive.a);
    SurfacePlace place{};
    if (primitive.kind == GeometryPrimitive::Kind::triangle) {
        place.normal = glm::normalize(glm::cross(dvec3(primitive.b) - a, dvec3(primitive.c) - a));
        place.point = hit - glm::dot(hit - a, place.normal) * place.normal;
    } else if (primitive.kind == GeometryPrimitive::Kind::other) {
        place = place_on_other(geometry.others[primitive.blocks], primitive.lane, hit);
    } else {
        place.normal = glm::normalize(hit - a);
        place.point = a + std::abs(double(primitive.b.x)) * place.normal;
    }
    place.error = dvec3(0x1p-20 * std::max({std::abs(place.point.x), std::abs(place.point.y), std::abs(place.point.z)}));
    return place;
}

/// To which tracers transform rays, with roundings of their own.
SurfacePlace place_in_world(const SurfacePlace &place, const Instance &instance) {
    const PlaceMap to_world(instance.to_world), to_group(instance.to_group);
    const dvec3 point = to_world.point(place.point), back = to_group.sizes * glm::abs(point) + glm::abs(to_group.origin);
    const dvec3 error = to_world.sizes * (place.error + 0x1p-20 * (glm::abs(place.point) + back)) + 0x1p-20 * glm::abs(point);
    return {point, error, glm::normalize(glm::transpose(to_group.linear) * place.normal)};
}

SurfacePlace place_of(const SceneGeometry &geometry, const Ray &ray, const Hit &hit, uint instance) {
    const dvec3 in_world = dvec3(ray.origin) + double(hit.t) * dvec3(ray.direction);
    const GeometryPrimitive &primitive = geometry.primitives[hit.primitive];
    SurfacePlace place = instance == 0
                             ? place_on(geometry, primitive, in_world)
                             : place_in_world(place_on(geometry, primitive, PlaceMap(geometry.instances[instance].to_group).point(in_world)),
                                              geometry.instances[instance]);
    if (glm::dot(place.normal, dvec3(ray.direction)) > 0) place.normal = -place.normal;
    return place;
}

/// Same bits everywhere: a mixer of 64 bits (splitmix64's), one stream per set.
double random_unit(std::uint64_t stream, std::uint64_t i) {
    std::uint64_t x = (stream << 48) + (i + 1) * 0x9e3779b97f4a7c15u;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return static_cast<double>((x ^ x >> 31) >> 11) * 0x1p-53;
}

/// Above the surface, by the cosine.
dvec3 cosine_direction(dvec3 normal, double u, double v) {
    const dvec3 aside = std::abs(normal.x) > 0.5 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
    const dvec3 x = glm::normalize(glm::cross(aside, normal)), y = glm::cross(normal, x);
    const double radius = std::sqrt(u), angle = 2 * std::numbers::pi * v;
    return glm::normalize(radius * std::cos(angle) * x + radius * std::sin(angle) * y + std::sqrt(1 - u) * normal);
}

/// A ray that says which primitive it leaves, and in which instance, as those of a render do.
struct TaggedRay {
    Ray ray;
    uint instance;
};

class RayMaker {
public:
    RayMaker(const SceneGeometry &geometry, vec3 light, const FindHits &find_hits) : geometry_(geometry), light_(light), find_hits_(find_hits) {}

    RayQueue camera_rays(const Camera &camera) const {
        const std::vector<uint> pixels = PixelOrder(Window{0, 0, camera.width, camera.height}).next(std::size_t{camera.width} * camera.height);
        const Perspective view = view_of<Perspective>(camera.words);
        return queue(RayQueue::Use::camera, false, pixels.size(), [&](std::size_t i) -> std::optional<TaggedRay> {
            const double x = ((pixels[i] & 0xffff) + 0.5) / camera.width, y = ((pixels[i] >> 16) + 0.5) / camera.height;
            const dvec3 way = dvec3(view.corner) + x * dvec3(view.right) + y * dvec3(view.down);
            return TaggedRay{{camera.position, infinity, vec3(glm::normalize(way)), RAY_TAG(RAY_CAMERA, NO_HIT)}, 0};
        });
    }

    RayQueue bounces(const RayQueue &from, uint generation) const {
        return leaving(from, RayQueue::Use::secondary, false, [&](const SurfacePlace &place, std::size_t i) -> std::optional<Ray> {
            const dvec3 way = cosine_direction(place.normal, random_unit(generation, 2 * i), random_unit(generation, 2 * i + 1));
            return Ray{place.origin(), infinity, vec3(way), RAY_TAG(RAY_REFLECTED, NO_HIT)};
        });
    }

    RayQueue shadows(const RayQueue &from) const {
        return leaving(from, RayQueue::Use::shadow, true, [&](const SurfacePlace &place, std::size_t) -> std::optional<Ray> {
            const vec3 origin = place.origin();
            const dvec3 way = dvec3(light_) - dvec3(origin);
            const double distance = glm::length(way);
            if (glm::dot(way, place.normal) <= 0) return {};
            return Ray{origin, static_cast<float>(distance), vec3(way / distance), RAY_TAG(RAY_SHADOW, NO_HIT)};
        });
    }

private:
    template <class Leave> RayQueue leaving(const RayQueue &from, RayQueue::Use use, bool shadow, Leave leave) const {
        const RayAnswers found = find_hits_(from);
        return queue(use, shadow, from.count(), [&](std::size_t i) -> std::optional<TaggedRay> {
            const Hit &hit = found.hits[i];
            if (hit.primitive == NO_HIT) return {};
            std::optional<Ray> ray = leave(place_of(geometry_, from.rays[i], hit, found.instances[i]), i);
            if (!ray) return {};
            ray->tag = RAY_TAG(RAY_KIND(ray->tag), hit.primitive);
            return TaggedRay{*ray, found.instances[i]};
        });
    }

    /// Of what `make` gives for 0 ... count - 1, in this order. Bounces are diffuse, and scattered therefore.
    template <class Make> RayQueue queue(RayQueue::Use use, bool shadow, std::size_t count, Make make) const {
        std::vector<std::optional<TaggedRay>> rays(count);
        tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { rays[i] = make(i); });
        RayQueue queue{use, shadow, use != RayQueue::Use::secondary, {}, {}};
        for (const std::optional<TaggedRay> &ray : rays)
            if (ray) queue.rays.push_back(ray->ray), queue.sources.push_back(ray->instance);
        return queue;
    }

    const SceneGeometry &geometry_;
    vec3 light_;
    const FindHits &find_hits_;
};

/// The same rays, but for the question.
RayQueue asking_for_any(RayQueue queue) {
    queue.use = RayQueue::Use::shadow, queue.shadow = true;
    for (Ray &ray : queue.rays) ray.tag = RAY_TAG(RAY_SHADOW, RAY_SOURCE(ray.tag));
    return queue;
}

}  // namespace

const std::vector<std::string> &ray_set_names() {
    static const std::vector<std::string> names = {"camera", "diffuse", "diffuse2", "shadow", "any"};
    return names;
}

vec3 shadow_light(const Scene &scene) {
    for (const Light &light : scene.lights) {
        const std::string kind = light_kinds()[light.kind].name;
        if (kind != "point" && kind != "spot") continue;
        vec3 position;
        std::memcpy(&position, light.words, sizeof position);
        return position;
    }
    Bounds box;
    for (const auto &shape : scene.shapes)
        for (std::size_t i = 0; i < shape->count(); ++i) box.add(shape->bounds(i));
    for (const PlacedGroup &instance : scene.instances) box.add(instance.bounds);
    if (box.empty()) return {0, 1, 0};
    const vec3 size = box.high - box.low;
    return {0.5f * (box.low.x + box.high.x), box.high.y + std::max(size.x, size.z), 0.5f * (box.low.z + box.high.z)};
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
