#include "tools/bench/embree_scenes.h"

#include <fmt/format.h>

#include <bit>
#include <unordered_map>

#include "runtime/opencl/error.h"
#include "runtime/opencl/seconds_now.h"

namespace brandung {
namespace {

[[noreturn]] void fail(RTCDevice device, const std::string &what) {
    throw Error(fmt::format("Embree: {} failed with error {}", what, static_cast<int>(rtcGetDeviceError(device))));
}

struct HashOfPlace {
    std::size_t operator()(const vec3 &p) const {
        std::uint64_t hash = 0;
        for (int axis = 0; axis < 3; ++axis) hash = (hash ^ std::bit_cast<uint>(p[axis])) * 0x9e3779b97f4a7c15u;
        return hash ^ hash >> 32;
    }
};

}  // namespace

EmbreeScenes::SharedBuffers EmbreeScenes::buffers_of(const SceneGeometry &geometry, const GeometrySpace &space) {
    SharedBuffers buffers;
    std::unordered_map<vec3, uint, HashOfPlace> places;
    for (uint i = space.first; i < space.end; ++i) {
        const GeometryPrimitive &primitive = geometry.primitives[i];
        if (primitive.kind == GeometryPrimitive::Kind::sphere) {
            buffers.spheres.emplace_back(primitive.a, primitive.b.x), buffers.sphere_numbers.push_back(i);
            continue;
        }
        for (const vec3 &corner : {primitive.a, primitive.b, primitive.c}) {
            const auto [place, is_new] = places.try_emplace(corner, static_cast<uint>(buffers.corners.size()));
            if (is_new) buffers.corners.push_back(corner);
            buffers.indices.push_back(place->second);
        }
        buffers.triangle_numbers.push_back(i);
    }
    buffers.corners.emplace_back();  // Embree reads 16 bytes of the last one
    return buffers;
}

EmbreeScenes::EmbreeScenes(const SceneGeometry &geometry, uint threads)
    : geometry_(geometry), device_(rtcNewDevice(fmt::format("threads={}", threads).c_str())) {
    if (!device_) fail(nullptr, "rtcNewDevice");
    rtcSetDeviceMemoryMonitorFunction(
        device_, [](void *sum, ssize_t bytes, bool) { return *static_cast<std::atomic<std::int64_t> *>(sum) += bytes, true; }, &allocated_);
    for (const GeometrySpace &space : geometry.spaces) buffers_.push_back(buffers_of(geometry, space));
    list_ = {{"medium", false, false}, {"high", true, false}, {"robust", false, true}};
    for (PeerScene &scene : list_) built_.push_back(build(scene));
}

void EmbreeScenes::build_again() {
    for (PeerScene &scene : list_) release(build(scene));
}

void EmbreeScenes::release(const Built &built) {
    rtcReleaseScene(built.world);
    for (const RTCScene group : built.groups) rtcReleaseScene(group);
}

EmbreeScenes::~EmbreeScenes() {
    for (const Built &built : built_) release(built);
    rtcReleaseDevice(device_);
}

uint EmbreeScenes::number_of(uint instance, uint geometry, uint primitive) const {
    return (*buffers_[geometry_.space_of(instance)].numbers[geometry])[primitive];
}

EmbreeScenes::Built EmbreeScenes::build(PeerScene &made) {
    const RTCBuildQuality quality = made.high ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM;
    const std::int64_t before = allocated_;
    const double start = seconds_now();
    Built built{};
    for (std::size_t space = 1; space < buffers_.size(); ++space) built.groups.push_back(new_scene(space, made.robust, quality));
    for (const RTCScene group : built.groups) rtcCommitScene(group);
    built.world = new_scene(0, made.robust, quality);
    for (uint i = 1; i < geometry_.instances.size(); ++i) add_instance(built.world, built.groups[geometry_.instances[i].group], i);
    rtcCommitScene(built.world);
    made.build_seconds.push_back(seconds_now() - start);
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) fail(device_, "building a scene");
    made.bytes = static_cast<std::size_t>(allocated_ - before);
    return built;
}

RTCScene EmbreeScenes::new_scene(std::size_t space, bool robust, RTCBuildQuality quality) {
    const RTCScene scene = rtcNewScene(device_);
    if (robust) rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, quality);
    SharedBuffers &shared = buffers_[space];
    shared.numbers.clear();
    if (!shared.indices.empty()) {
        const RTCGeometry triangles = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(triangles, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, shared.corners.data(), 0, sizeof(vec3),
                                   shared.corners.size() - 1);
        rtcSetSharedGeometryBuffer(triangles, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, shared.indices.data(), 0, 3 * sizeof(uint),
                                   shared.indices.size() / 3);
        add(scene, triangles, quality, shared, shared.triangle_numbers);
    }
    if (!shared.spheres.empty()) {
        const RTCGeometry spheres = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        rtcSetSharedGeometryBuffer(spheres, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, shared.spheres.data(), 0, sizeof(glm::vec4),
                                   shared.spheres.size());
        add(scene, spheres, quality, shared, shared.sphere_numbers);
    }
    return scene;
}

void EmbreeScenes::add(RTCScene scene, RTCGeometry added, RTCBuildQuality quality, SharedBuffers &shared, const Numbers &numbers) {
    rtcSetGeometryBuildQuality(added, quality);
    rtcCommitGeometry(added);
    rtcAttachGeometryByID(scene, added, static_cast<uint>(shared.numbers.size()));
    rtcReleaseGeometry(added);
    shared.numbers.push_back(&numbers);
}

/// Its geometries come after those of the world, at most two.
void EmbreeScenes::add_instance(RTCScene world, RTCScene group, uint instance) {
    const RTCGeometry placed = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(placed, group);
    rtcSetGeometryTransform(placed, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, &geometry_.instances[instance].to_world);
    rtcCommitGeometry(placed);
    rtcAttachGeometryByID(world, placed, instance + 1);
    rtcReleaseGeometry(placed);
}

}  // namespace brandung
