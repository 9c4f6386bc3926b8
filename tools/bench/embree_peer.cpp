#include "tools/bench/embree_peer.h"

#include <fmt/format.h>
#include <immintrin.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstring>

#include "runtime/opencl/seconds_now.h"
#include "tools/bench/embree_scenes.h"

namespace brandung {
namespace {

constexpr std::size_t lanes = 16;         ///< of a block of rays, which narrower packets take in parts
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
template <> struct Packet<4> {
    using Rays = RTCRay4;
    using Hits = RTCRayHit4;
    static constexpr auto intersect = rtcIntersect4;
    static constexpr auto occluded = rtcOccluded4;
};
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

/// What follows is compiled for the widest vectors too, where the compiler can: copying is a part of what is measured.
#if defined(__has_attribute)
#if __has_attribute(target_clones)
#define FOR_ALL_VECTORS __attribute__((target_clones("avx512f", "avx2", "default")))
#endif
#endif
#ifndef FOR_ALL_VECTORS
#define FOR_ALL_VECTORS
#endif

template <uint width, class Rays> [[gnu::always_inline]] inline void fill_lanes(Rays &rays, const RayBlock &block, std::size_t first) {
    constexpr std::size_t bytes = width * sizeof(float);
    std::memcpy(rays.org_x, block.origin[0] + first, bytes), std::memcpy(rays.org_y, block.origin[1] + first, bytes);
    std::memcpy(rays.org_z, block.origin[2] + first, bytes), std::memcpy(rays.dir_x, block.direction[0] + first, bytes);
    std::memcpy(rays.dir_y, block.direction[1] + first, bytes), std::memcpy(rays.dir_z, block.direction[2] + first, bytes);
    std::memcpy(rays.tfar, block.t_max + first, bytes), std::memset(rays.tnear, 0, bytes), std::memset(rays.time, 0, bytes);
    std::memset(rays.mask, 0xff, bytes), std::memset(rays.flags, 0, bytes);
}

template <uint width, class Hits> [[gnu::always_inline]] inline void store_lanes(HitBlock &block, std::size_t first, const Hits &hits) {
    constexpr std::size_t bytes = width * sizeof(float);
    std::memcpy(block.t + first, hits.ray.tfar, bytes), std::memcpy(block.u + first, hits.hit.u, bytes);
    std::memcpy(block.v + first, hits.hit.v, bytes), std::memcpy(block.primitive + first, hits.hit.primID, bytes);
    std::memcpy(block.geometry + first, hits.hit.geomID, bytes), std::memcpy(block.instance + first, hits.hit.instID[0], bytes);
}

FOR_ALL_VECTORS void fill(RTCRay4 &rays, const RayBlock &block, std::size_t first) { fill_lanes<4>(rays, block, first); }
FOR_ALL_VECTORS void fill(RTCRay8 &rays, const RayBlock &block, std::size_t first) { fill_lanes<8>(rays, block, first); }
FOR_ALL_VECTORS void fill(RTCRay16 &rays, const RayBlock &block, std::size_t first) { fill_lanes<16>(rays, block, first); }
FOR_ALL_VECTORS void store(HitBlock &block, std::size_t first, const RTCRayHit4 &hits) { store_lanes<4>(block, first, hits); }
FOR_ALL_VECTORS void store(HitBlock &block, std::size_t first, const RTCRayHit8 &hits) { store_lanes<8>(block, first, hits); }
FOR_ALL_VECTORS void store(HitBlock &block, std::size_t first, const RTCRayHit16 &hits) { store_lanes<16>(block, first, hits); }

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

}  // namespace

struct EmbreePeer::Implementation {
    Implementation(const SceneGeometry &geometry, uint threads) : arena(static_cast<int>(threads)), scenes(geometry, threads) {}

    void take(const RaySpan &span) {
        taken = span;
        const std::size_t count = (taken.rays.size() + lanes - 1) / lanes;
        blocks.resize(count), found_blocks.resize(count), found.resize(taken.rays.size()), found_any.resize(count * lanes);
        for (std::size_t i = 0; i < count * lanes; ++i) {
            const Ray &ray = taken.rays[std::min(i, taken.rays.size() - 1)];  // the last one fills its block
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
                    trace(range.begin() * lanes, std::min(range.end() * lanes, taken.rays.size()));
                },
                tbb::simple_partitioner());
        });
    }

    void trace_singly(RTCScene scene, RTCIntersectContextFlags flags) {
        for_all_rays([&](std::size_t first, std::size_t end) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            context.flags = flags;
            for (std::size_t i = first; i < end; ++i) taken.shadow ? ask_any(scene, context, i) : ask_closest(scene, context, i);
        });
    }

    void ask_any(RTCScene scene, RTCIntersectContext &context, std::size_t i) {
        RTCRay ray = single_ray(taken.rays[i]);
        rtcOccluded1(scene, &context, &ray);
        found_any[i] = ray.tfar >= 0;
    }

    void ask_closest(RTCScene scene, RTCIntersectContext &context, std::size_t i) {
        RTCRayHit ray;
        ray.ray = single_ray(taken.rays[i]);
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
                taken.shadow ? ask_any<width>(scene, context, i, valid) : ask_closest<width>(scene, context, i, valid);
        });
    }

    template <uint width> void ask_any(RTCScene scene, RTCIntersectContext &context, std::size_t i, const int *valid) {
        typename Packet<width>::Rays rays;
        fill(rays, blocks[i / lanes], i % lanes);
        Packet<width>::occluded(valid, scene, &context, &rays);
        for (std::size_t lane = 0; lane < width; ++lane) found_any[i + lane] = rays.tfar[lane] >= 0;
    }

    template <uint width> void ask_closest(RTCScene scene, RTCIntersectContext &context, std::size_t i, const int *valid) {
        typename Packet<width>::Hits rays;
        fill(rays.ray, blocks[i / lanes], i % lanes);
        constexpr std::size_t bytes = width * sizeof(uint);
        std::memset(rays.hit.geomID, 0xff, bytes), std::memset(rays.hit.primID, 0xff, bytes), std::memset(rays.hit.instID[0], 0xff, bytes);
        Packet<width>::intersect(valid, scene, &context, &rays);
        store(found_blocks[i / lanes], i % lanes, rays);
    }

    SingleHit found_at(std::size_t i) const {
        if (width == 1) return found[i];
        const HitBlock &block = found_blocks[i / lanes];
        const std::size_t lane = i % lanes;
        return {block.t[lane], block.u[lane], block.v[lane], block.primitive[lane], block.geometry[lane], block.instance[lane]};
    }

    tbb::task_arena arena;
    EmbreeScenes scenes;
    RaySpan taken{};
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
    const auto number = rtcGetDeviceProperty(implementation_->scenes.device(), RTC_DEVICE_PROPERTY_VERSION);
    return fmt::format("{}.{}.{}", number / 10000, number / 100 % 100, number % 100);
}

uint EmbreePeer::native_width() const {
    if (rtcGetDeviceProperty(implementation_->scenes.device(), RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)) return 16;
    return rtcGetDeviceProperty(implementation_->scenes.device(), RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) ? 8 : 4;
}

std::string EmbreePeer::instructions() const {
    if (native_width() == 16) return "AVX-512";
    if (native_width() == 8) return __builtin_cpu_supports("avx2") ? "AVX2" : "AVX";
    return "SSE";
}

const std::vector<PeerScene> &EmbreePeer::scenes() const { return implementation_->scenes.list(); }
void EmbreePeer::take(const RaySpan &rays) { implementation_->take(rays); }
void EmbreePeer::build_again() { implementation_->scenes.build_again(); }

bool EmbreePeer::can_trace(const PeerApi &api, bool any) const {
    return !(any && api.width == 16 && api.coherent && !implementation_->scenes.geometry().instances.empty());
}

double EmbreePeer::trace(std::size_t scene, const PeerApi &api) {
    const RTCScene traced = implementation_->scenes.at(scene);
    const auto flags = api.coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    const double start = seconds_now();
    if (api.width == 1) implementation_->trace_singly(traced, flags);
    if (api.width == 4) implementation_->trace_packets<4>(traced, flags);
    if (api.width == 8) implementation_->trace_packets<8>(traced, flags);
    if (api.width == 16) implementation_->trace_packets<16>(traced, flags);
    const double end = seconds_now();
    implementation_->width = api.width;
    return end - start;
}

RayAnswers EmbreePeer::answers() const {
    const std::size_t count = implementation_->taken.rays.size();
    RayAnswers answers;
    if (implementation_->taken.shadow) {
        answers.visible.assign(implementation_->found_any.begin(), implementation_->found_any.begin() + static_cast<std::ptrdiff_t>(count));
        return answers;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const SingleHit hit = implementation_->found_at(i);
        const bool missed = hit.geometry == RTC_INVALID_GEOMETRY_ID;
        const uint instance = missed || hit.instance == RTC_INVALID_GEOMETRY_ID ? 0 : hit.instance - 1;
        const uint primitive = missed ? NO_HIT : implementation_->scenes.number_of(instance, hit.geometry, hit.primitive);
        answers.hits.push_back({hit.t, hit.u, hit.v, primitive});
        answers.instances.push_back(instance);
    }
    return answers;
}

}  // namespace brandung
