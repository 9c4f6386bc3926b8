#include "tools/bench/embree_peer.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <immintrin.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstring>

#include "runtime/opencl/error.h"
#include "runtime/opencl/seconds_now.h"

namespace brandung {
namespace {

constexpr std::size_t lanes = 16;         ///< of a block of rays, which packets of 8 take in halves
constexpr std::size_t task_blocks = 128;  ///< that a task traces

/// As those who trace packets keep their rays: what they copy is a row.
struct alignas(64) RayBlock {
    float origin[3][lanes], direction[3][lanes], t_max[lanes];
};

/// As much of what is found as anyone needs who shades it.
struct alignas(64) HitBlock {
    float t[lanes], u[lanes], v[lanes];
    uint primitive[lanes], geometry[lanes], instance[lanes];
};

struct SingleHit {
    float t, u, v;
    uint primitive, geometry, instance;
};

template <uint width> struct Packet;
template <> struct Packet<8> {
    using Rays = RTCRay8;
    using Hits = RTCRayHit8;
    static constexpr auto intersect = rtcIntersect8;
    static constexpr auto occluded = rtcOccluded8;
};
template <> struct Packet<16> {
    using Rays = RTCRay16;
    using Hits = RTCRayHit16;
    static constexpr auto intersect = rtcIntersect16;
    static constexpr auto occluded = rtcOccluded16;
};

template <uint width, class Rays> void fill(Rays &rays, const RayBlock &block, std::size_t first) {
    constexpr std::size_t bytes = width * sizeof(float);
    std::memcpy(rays.org_x, block.origin[0] + first, bytes), std::memcpy(rays.org_y, block.origin[1] + first, bytes);
    std::memcpy(rays.org_z, block.origin[2] + first, bytes), std::memcpy(rays.dir_x, block.direction[0] + first, bytes);
    std::memcpy(rays.dir_y, block.direction[1] + first, bytes), std::memcpy(rays.dir_z, block.direction[2] + first, bytes);
    std::memcpy(rays.tfar, block.t_max + first, bytes), std::memset(rays.tnear, 0, bytes), std::memset(rays.time, 0, bytes);
    std::memset(rays.mask, 0xff, bytes), std::memset(rays.flags, 0, bytes);
}

template <uint width, class Hits> void store(HitBlock &block, std::size_t first, const Hits &hits) {
    constexpr std::size_t bytes = width * sizeof(float);
    std::memcpy(block.t + first, hits.ray.tfar, bytes), std::memcpy(block.u + first, hits.hit.u, bytes);
    std::memcpy(block.v + first, hits.hit.v, bytes), std::memcpy(block.primitive + first, hits.hit.primID, bytes);
    std::memcpy(block.geometry + first, hits.hit.geomID, bytes), std::memcpy(block.instance + first, hits.hit.instID[0], bytes);
}

RTCRay single_ray(const Ray &ray) {
    RTCRay r;
    r.org_x = ray.origin.x, r.org_y = ray.origin.y, r.org_z = ray.origin.z, r.tnear = 0;
    r.dir_x = ray.direction.x, r.dir_y = ray.direction.y, r.dir_z = ray.direction.z, r.time = 0, r.tfar = ray.t_max;
    r.mask = 0xffffffff, r.id = 0, r.flags = 0;
    return r;
}

/// Subnormal numbers are zero meanwhile, as Embree's manual asks for.
class WithoutSubnormals {
public:
    WithoutSubnormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040); }
    ~WithoutSubnormals() { _mm_setcsr(before_); }
    WithoutSubnormals(const WithoutSubnormals &) = delete;

private:
    unsigned before_;
};

[[noreturn]] void fail(RTCDevice device, const std::string &what) {
    throw Error(fmt::format("Embree: {} failed with error {}", what, static_cast<int>(rtcGetDeviceError(device))));
}

/// Numbers of the scene's primitives by Embree's, of one geometry.
using Numbers = std::vector<uint>;

/// Copies of coordinates, which Embree's geometries share; one per space.
struct SharedBuffers {
    std::vector<vec3> corners;
    std::vector<uint> indices;
    std::vector<glm::vec4> spheres;
    Numbers triangle_numbers, sphere_numbers;
    std::vector<const Numbers *> numbers;  ///< by geometry
};

SharedBuffers buffers_of(const SceneGeometry &geometry, const GeometrySpace &space) {
    SharedBuffers buffers;
    for (uint i = space.first; i < space.end; ++i) {
        const GeometryPrimitive &primitive = geometry.primitives[i];
        if (primitive.kind == GeometryPrimitive::Kind::sphere) {
            buffers.spheres.emplace_back(primitive.a, primitive.b.x), buffers.sphere_numbers.push_back(i);
            continue;
        }
        for (const vec3 &corner : {primitive.a, primitive.b, primitive.c}) {
            buffers.indices.push_back(static_cast<uint>(buffers.corners.size()));
            buffers.corners.push_back(corner);
        }
        buffers.triangle_numbers.push_back(i);
    }
    buffers.corners.emplace_back();  // Embree reads 16 bytes of the last one
    return buffers;
}

}  // namespace

struct EmbreePeer::Implementation {
    Implementation(const SceneGeometry &geometry, uint threads)
        : geometry(geometry), arena(static_cast<int>(threads)), device(rtcNewDevice(fmt::format("threads={}", threads).c_str())) {
        if (!device) fail(nullptr, "rtcNewDevice");
        rtcSetDeviceMemoryMonitorFunction(
            device, [](void *sum, ssize_t bytes, bool) { return *static_cast<std::atomic<std::int64_t> *>(sum) += bytes, true; }, &allocated);
        for (const GeometrySpace &space : geometry.spaces) buffers.push_back(buffers_of(geometry, space));
        build("medium", false, RTC_BUILD_QUALITY_MEDIUM), build("high", false, RTC_BUILD_QUALITY_HIGH);
        build("robust", true, RTC_BUILD_QUALITY_MEDIUM);
    }

    ~Implementation() {
        for (const RTCScene scene : built) rtcReleaseScene(scene);
        for (const RTCScene scene : groups) rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }

    void build(const char *name, bool robust, RTCBuildQuality quality) {
        const std::int64_t before = allocated;
        const double start = seconds_now();
        std::vector<RTCScene> of_groups;
        for (std::size_t space = 1; space < buffers.size(); ++space) of_groups.push_back(new_scene(space, robust, quality));
        for (const RTCScene group : of_groups) rtcCommitScene(group);
        const RTCScene world = new_scene(0, robust, quality);
        for (uint i = 1; i < geometry.instances.size(); ++i) add_instance(world, of_groups[geometry.instances[i].group], i);
        rtcCommitScene(world);
        if (rtcGetDeviceError(device) != RTC_ERROR_NONE) fail(device, "building a scene");
        groups.insert(groups.end(), of_groups.begin(), of_groups.end());
        built.push_back(world);
        scenes.push_back({name, robust, seconds_now() - start, static_cast<std::size_t>(allocated - before)});
    }

    RTCScene new_scene(std::size_t space, bool robust, RTCBuildQuality quality) {
        const RTCScene scene = rtcNewScene(device);
        if (robust) rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(scene, quality);
        SharedBuffers &shared = buffers[space];
        shared.numbers.clear();
        if (!shared.indices.empty()) {
            const RTCGeometry triangles = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
            rtcSetSharedGeometryBuffer(triangles, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, shared.corners.data(), 0, sizeof(vec3),
                                       shared.corners.size() - 1);
            rtcSetSharedGeometryBuffer(triangles, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, shared.indices.data(), 0, 3 * sizeof(uint),
                                       shared.indices.size() / 3);
            add(scene, triangles, quality, shared, shared.triangle_numbers);
        }
        if (!shared.spheres.empty()) {
            const RTCGeometry spheres = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
            rtcSetSharedGeometryBuffer(spheres, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, shared.spheres.data(), 0, sizeof(glm::vec4),
                                       shared.spheres.size());
            add(scene, spheres, quality, shared, shared.sphere_numbers);
        }
        return scene;
    }

    static void add(RTCScene scene, RTCGeometry added, RTCBuildQuality quality, SharedBuffers &shared, const Numbers &numbers) {
        rtcSetGeometryBuildQuality(added, quality);
        rtcCommitGeometry(added);
        rtcAttachGeometryByID(scene, added, static_cast<uint>(shared.numbers.size()));
        rtcReleaseGeometry(added);
        shared.numbers.push_back(&numbers);
    }

    /// Its geometries come after those of the world, at most two.
    void add_instance(RTCScene world, RTCScene group, uint instance) {
        const RTCGeometry placed = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(placed, group);
        rtcSetGeometryTransform(placed, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, &geometry.instances[instance].to_world);
        rtcCommitGeometry(placed);
        rtcAttachGeometryByID(world, placed, instance + 1);
        rtcReleaseGeometry(placed);
    }

    void take(const RayQueue &taken) {
        queue = &taken;
        const std::size_t count = (taken.count() + lanes - 1) / lanes;
        blocks.resize(count), found_blocks.resize(count), found.resize(taken.count()), found_any.resize(count * lanes);
        for (std::size_t i = 0; i < count * lanes; ++i) {
            const Ray &ray = taken.rays[std::min(i, taken.count() - 1)];  // the last one fills its block
            RayBlock &block = blocks[i / lanes];
            const std::size_t lane = i % lanes;
            for (int axis = 0; axis < 3; ++axis) block.origin[axis][lane] = ray.origin[axis], block.direction[axis][lane] = ray.direction[axis];
            block.t_max[lane] = ray.t_max;
        }
    }

    /// Tasks of rays first ... end - 1 on all threads.
    template <class Trace> void for_all_rays(Trace trace) {
        arena.execute([&] {
            tbb::parallel_for(
                tbb::blocked_range<std::size_t>(0, blocks.size(), task_blocks),
                [&](const tbb::blocked_range<std::size_t> &range) {
                    const WithoutSubnormals without;
                    trace(range.begin() * lanes, std::min(range.end() * lanes, queue->count()));
                },
                tbb::simple_partitioner());
        });
    }

    void trace_singly(RTCScene scene, RTCIntersectContextFlags flags) {
        for_all_rays([&](std::size_t first, std::size_t end) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            context.flags = flags;
            for (std::size_t i = first; i < end; ++i) queue->shadow ? ask_any(scene, context, i) : ask_closest(scene, context, i);
        });
    }

    void ask_any(RTCScene scene, RTCIntersectContext &context, std::size_t i) {
        RTCRay ray = single_ray(queue->rays[i]);
        rtcOccluded1(scene, &context, &ray);
        found_any[i] = ray.tfar >= 0;
    }

    void ask_closest(RTCScene scene, RTCIntersectContext &context, std::size_t i) {
        RTCRayHit ray;
        ray.ray = single_ray(queue->rays[i]);
        ray.hit.geomID = ray.hit.primID = ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene, &context, &ray);
        found[i] = {ray.ray.tfar, ray.hit.u, ray.hit.v, ray.hit.primID, ray.hit.geomID, ray.hit.instID[0]};
    }

    template <uint width> void trace_packets(RTCScene scene, RTCIntersectContextFlags flags) {
        for_all_rays([&](std::size_t first, std::size_t end) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            context.flags = flags;
            alignas(64) int valid[width];
            std::fill(valid, valid + width, -1);
            for (std::size_t i = first; i < end; i += width)
                queue->shadow ? ask_any<width>(scene, context, i, valid) : ask_closest<width>(scene, context, i, valid);
        });
    }

    template <uint width> void ask_any(RTCScene scene, RTCIntersectContext &context, std::size_t i, const int *valid) {
        typename Packet<width>::Rays rays;
        fill<width>(rays, blocks[i / lanes], i % lanes);
        Packet<width>::occluded(valid, scene, &context, &rays);
        for (std::size_t lane = 0; lane < width; ++lane) found_any[i + lane] = rays.tfar[lane] >= 0;
    }

    template <uint width> void ask_closest(RTCScene scene, RTCIntersectContext &context, std::size_t i, const int *valid) {
        typename Packet<width>::Hits rays;
        fill<width>(rays.ray, blocks[i / lanes], i % lanes);
        constexpr std::size_t bytes = width * sizeof(uint);
        std::memset(rays.hit.geomID, 0xff, bytes), std::memset(rays.hit.primID, 0xff, bytes), std::memset(rays.hit.instID[0], 0xff, bytes);
        Packet<width>::intersect(valid, scene, &context, &rays);
        store<width>(found_blocks[i / lanes], i % lanes, rays);
    }

    SingleHit found_at(std::size_t i) const {
        if (width == 1) return found[i];
        const HitBlock &block = found_blocks[i / lanes];
        const std::size_t lane = i % lanes;
        return {block.t[lane], block.u[lane], block.v[lane], block.primitive[lane], block.geometry[lane], block.instance[lane]};
    }

    const SceneGeometry &geometry;
    tbb::task_arena arena;
    RTCDevice device;
    std::atomic<std::int64_t> allocated = 0;
    std::vector<SharedBuffers> buffers;  ///< by space
    std::vector<PeerScene> scenes;
    std::vector<RTCScene> built, groups;
    const RayQueue *queue = nullptr;
    std::vector<RayBlock> blocks;
    uint width = 1;  ///< of the last trace()
    std::vector<SingleHit> found;
    std::vector<HitBlock> found_blocks;
    std::vector<std::uint8_t> found_any;
};

void EmbreePeer::check_built_in() {}

std::string EmbreePeer::refusal(const SceneGeometry &geometry) {
    for (const GeometryPrimitive &primitive : geometry.primitives) {
        if (primitive.kind == GeometryPrimitive::Kind::other) return "it has only triangles and spheres";
        if (primitive.kind == GeometryPrimitive::Kind::sphere && primitive.b.x < 0) return "it has no spheres of which only the inside is visible";
    }
    return "";
}

EmbreePeer::EmbreePeer(const SceneGeometry &geometry, uint threads) : implementation_(std::make_unique<Implementation>(geometry, threads)) {}
EmbreePeer::~EmbreePeer() = default;

std::string EmbreePeer::version() const {
    const auto number = rtcGetDeviceProperty(implementation_->device, RTC_DEVICE_PROPERTY_VERSION);
    return fmt::format("{}.{}.{}", number / 10000, number / 100 % 100, number % 100);
}

uint EmbreePeer::native_width() const {
    if (rtcGetDeviceProperty(implementation_->device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)) return 16;
    return rtcGetDeviceProperty(implementation_->device, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) ? 8 : 4;
}

const std::vector<PeerScene> &EmbreePeer::scenes() const { return implementation_->scenes; }
void EmbreePeer::take(const RayQueue &queue) { implementation_->take(queue); }

bool EmbreePeer::can_trace(const PeerApi &api) const {
    return !(implementation_->queue->shadow && api.width == 16 && api.coherent && !implementation_->geometry.instances.empty());
}

double EmbreePeer::trace(std::size_t scene, const PeerApi &api) {
    const RTCScene traced = implementation_->built[scene];
    const auto flags = api.coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    const double start = seconds_now();
    if (api.width == 1) implementation_->trace_singly(traced, flags);
    if (api.width == 8) implementation_->trace_packets<8>(traced, flags);
    if (api.width == 16) implementation_->trace_packets<16>(traced, flags);
    const double end = seconds_now();
    implementation_->width = api.width;
    return end - start;
}

RayAnswers EmbreePeer::answers() const {
    const std::size_t count = implementation_->queue->count();
    RayAnswers answers;
    if (implementation_->queue->shadow) {
        answers.visible.assign(implementation_->found_any.begin(), implementation_->found_any.begin() + static_cast<std::ptrdiff_t>(count));
        return answers;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const SingleHit hit = implementation_->found_at(i);
        const bool missed = hit.geometry == RTC_INVALID_GEOMETRY_ID;
        const uint instance = missed || hit.instance == RTC_INVALID_GEOMETRY_ID ? 0 : hit.instance - 1;
        const std::size_t space = instance == 0 ? 0 : implementation_->geometry.instances[instance].group + 1;
        const uint primitive = missed ? NO_HIT : (*implementation_->buffers[space].numbers[hit.geometry])[hit.primitive];
        answers.hits.push_back({hit.t, hit.u, hit.v, primitive});
        answers.instances.push_back(instance);
    }
    return answers;
}

}  // namespace brandung
