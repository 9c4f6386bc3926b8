#include "tools/bench/embree_scenes.h"

#include <fmt/format.h>

#include "runtime/opencl/error.h"
#include "runtime/opencl/seconds_now.h"

namespace brandung {
namespace {

[[noreturn]] void fail(RTCDevice device, const std::string &what) {
    throw Error(fmt::format("Embree: {} failed with error {}", what, static_cast<int>(rtcGetDeviceError(device))));
}

}  // namespace

EmbreeScenes::SharedBuffers EmbreeScenes::buffers_of(const SceneGeometry &geometry, const GeometrySpace &space) {
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

EmbreeScenes::EmbreeScenes(const SceneGeometry &geometry, uint threads)
    : geometry_(geometry), device_(rtcNewDevice(fmt::format("threads={}", threads).c_str())) {
    if (!device_) fail(nullptr, "rtcNewDevice");
    rtcSetDeviceMemoryMonitorFunction(
        device_, [](void *sum, ssize_t bytes, bool) { return *static_cast<std::atomic<std::int64_t> *>(sum) += bytes, true; }, &allocated_);
    for (const GeometrySpace &space : geometry.spaces) buffers_.push_back(buffers_of(geometry, space));
    build("medium", false, RTC_BUILD_QUALITY_MEDIUM), build("high", false, RTC_BUILD_QUALITY_HIGH);
    build("robust", true, RTC_BUILD_QUALITY_MEDIUM);
}

EmbreeScenes::~EmbreeScenes() {
    for (const RTCScene scene : built_) rtcReleaseScene(scene);
    for (const RTCScene scene : groups_) rtcReleaseScene(scene);
    rtcReleaseDevice(device_);
}

uint EmbreeScenes::number_of(uint instance, uint geometry, uint primitive) const {
    const std::size_t space = instance == 0 ? 0 : geometry_.instances[instance].group + 1;
    return (*buffers_[space].numbers[geometry])[primitive];
}

void EmbreeScenes::build(const char *name, bool robust, RTCBuildQuality quality) {
    const std::int64_t before = allocated_;
    const double start = seconds_now();
    std::vector<RTCScene> of_groups;
    for (std::size_t space = 1; space < buffers_.size(); ++space) of_groups.push_back(new_scene(space, robust, quality));
    for (const RTCScene group : of_groups) rtcCommitScene(group);
    const RTCScene world = new_scene(0, robust, quality);
    for (uint i = 1; i < geometry_.instances.size(); ++i) add_instance(world, of_groups[geometry_.instances[i].group], i);
    rtcCommitScene(world);
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) fail(device_, "building a scene");
    groups_.insert(groups_.end(), of_groups.begin(), of_groups.end());
    built_.push_back(world);
    list_.push_back({name, robust, seconds_now() - start, static_cast<std::size_t>(allocated_ - before)});
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
