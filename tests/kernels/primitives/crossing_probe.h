/// A kind's crossing function on pairs of one primitive and one ray, and the rays that leave from its hits.
#pragma once
#include <cstring>
#include <memory>
#include <vector>

#include "kernels/core/items.h"
#include "kernels/core/scene.h"
#include "kernels/primitives/surface.h"
#include "scene/primitives/shape.h"
#include "tests/support/probe.h"

namespace brandung {

/// What `<kind>_crossing` gives.
struct CrossingResult {
    float t, u, v;
    uint hit;
};

/// A hit's surface, the origin of the ray that leaves it in a given direction, and where that ray meets the same primitive.
struct SpawnResult {
    CrossingResult first, second;
    Surface surface;
    vec3 origin;
};

/// `Block` is the kind's block of the arena.
template <class Block> class CrossingProbe {
public:
    /// Of primitives that are alone in their shapes.
    CrossingProbe(const PrimitiveKind &kind, const std::vector<std::unique_ptr<Shape>> &shapes)
        : lists_(lists_of(kind)), blocks_((shapes.size() + BLOCK_SIZE - 1) / BLOCK_SIZE), records_(shapes.size()), extents_(shapes.size()) {
        std::memset(static_cast<void *>(blocks_.data()), 0xff, blocks_.size() * sizeof(Block));
        SharedTables tables;
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            Block &block = blocks_[i / BLOCK_SIZE];
            block.primitive[i % BLOCK_SIZE] = uint(i);
            shapes[i]->write_lane(0, uint(i % BLOCK_SIZE), reinterpret_cast<std::byte *>(&block));
            shapes[i]->write_shading(0, records_[i].words, tables);
            const Bounds bounds = shapes[i]->bounds(0);
            const vec3 far = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
            extents_[i] = std::max({far.x, far.y, far.z});
        }
    }

    /// Result i is that of primitive i and ray i.
    std::vector<CrossingResult> crossings(const std::vector<Ray> &rays) const {
        return Probe(text() + R"(
            kernel void probe(const global Block *blocks, const global float *extents, const global Ray *rays, global Result *results) {
                const uint i = get_global_id(0);
                results[i] = cross_one(blocks, i, rays[i], extents[i]);
            })",
                     lists_)
            .template run<CrossingResult>(blocks_, extents_, rays);
    }

    /// Pairs as above; from each hit a ray leaves in directions[i].
    std::vector<SpawnResult> spawned(const std::vector<Ray> &rays, const std::vector<vec3> &directions) const {
        return Probe(text() + R"(
#include "generated/primitive_surfaces.cl"
#include "kernels/core/spawn.cl"
            typedef struct { Result first, second; Surface surface; vec3 origin; } Spawned;
            kernel void probe(const global Block *blocks, const global ShadingRecord *records, const global float *extents, const global Ray *rays,
                              const global vec3 *directions, global Spawned *results) {
                const uint i = get_global_id(0);
                const Scene scene = {0, 0};
                const Ray ray = rays[i];
                results[i].first = cross_one(blocks, i, ray, extents[i]);
                if (!results[i].first.hit) return;
                Hit hit;
                hit.t = results[i].first.t, hit.u = results[i].first.u, hit.v = results[i].first.v, hit.primitive = i;
                const Surface surface = NAME(surface)(scene, records[i], ray, hit);
                const float side = dot3(surface.geometric, directions[i]) < 0.0f ? -1.0f : 1.0f;
                const vec3 offset = scaled(surface.geometric, side * dot3(absolute(surface.geometric), surface.error));
                const Ray next = ray_spawn(spawn_origin(surface.p, offset), directions[i], RAY_REFLECTED, NO_HIT);
                results[i].surface = surface;
                results[i].origin = next.origin;
                results[i].second = cross_one(blocks, i, next, extents[i]);
            })",
                     lists_)
            .template run<SpawnResult>(blocks_, records_, extents_, rays, directions);
    }

private:
    static Sources lists_of(const PrimitiveKind &kind) {
        const std::string name = kind.name, path = "#include \"kernels/primitives/" + name;
        return {
            {"generated/constants.h", "#define INTERIOR_SIZE 0u\n#define INSTANCES 0\n"},
            {"generated/time.cl", "#include \"kernels/core/no_time.cl\"\n"},
            {"generated/work.cl", "#include \"kernels/accelerators/no_work.cl\"\n"},
            {"generated/single_ray.cl", "#include \"kernels/accelerators/single_ray_x8.cl\"\n"},
            {"generated/instances.cl", "#include \"kernels/primitives/no_instance.cl\"\n"},
            {"generated/primitives.cl", "#pragma once\n" + path + ".h\"\n#define FOR_EACH_PRIMITIVE(X) X(0, " + kind.record + ", " + name + ")\n"},
            {"generated/primitive_hits.cl", path + "_hit.cl\"\n"},
            {"generated/primitive_surfaces.cl", "#pragma once\n" + path + ".cl\"\n"},
            {"kind.h", std::string("#define NAME(function) ") + name + "_##function\ntypedef " + kind.record + "Block Block;\n"}};
    }

    static std::string text() {
        return R"(#include "kernels/accelerators/leaf.cl"
#include "kernels/core/lanes_1.cl"
#include "generated/primitive_hits.cl"
#include "kind.h"
            typedef struct { float t, u, v; uint hit; } Result;
            FUNCTION Result cross_one(const global Block *blocks, uint i, Ray ray, float extent) {
                const ray_x1 lane = lane_ray(ray.origin, ray.direction, ray.t_max, major_axis(ray.direction), (int)RAY_SOURCE(ray.tag), extent);
                const crossing_x1 c = NAME(crossing)(blocks + i / BLOCK_SIZE, i % BLOCK_SIZE, lane);
                const Result result = {c.t, c.u, c.v, c.hit != 0};
                return result;
            }
)";
    }

    Sources lists_;
    std::vector<Block> blocks_;
    std::vector<ShadingRecord> records_;
    std::vector<float> extents_;
};

}  // namespace brandung
