/// EmbreeScenes: a scene in Embree's structures. Part of EmbreePeer, where the program is built with Embree.
#pragma once
#include <embree3/rtcore.h>

#include <atomic>
#include <vector>

#include "tools/bench/embree_peer.h"
#include "tools/bench/scene_geometry.h"

namespace brandung {

class EmbreeScenes {
public:
    /// Builds all, of a geometry that must live as long. Throws Error if Embree fails.
    EmbreeScenes(const SceneGeometry &geometry, uint threads);
    /// Builds each once more, for its time.
    void build_again();
    ~EmbreeScenes();
    EmbreeScenes(const EmbreeScenes &) = delete;

    RTCDevice device() const { return device_; }
    const SceneGeometry &geometry() const { return geometry_; }
    const std::vector<PeerScene> &list() const { return list_; }
    RTCScene at(std::size_t i) const { return built_[i].world; }
    /// The scene's number of a primitive that Embree counts within a geometry, of the world for instance 0.
    uint number_of(uint instance, uint geometry, uint primitive) const;

private:
    /// Numbers of the scene's primitives by Embree's, of one geometry.
    using Numbers = std::vector<uint>;

    /// Copies of coordinates, which Embree's geometries share; one per space.
    struct SharedBuffers {
        std::vector<vec3> corners;  ///< each place once, as in a mesh
        std::vector<uint> indices;
        std::vector<glm::vec4> spheres;
        Numbers triangle_numbers, sphere_numbers;
        std::vector<const Numbers *> numbers;  ///< by geometry
    };

    /// The world's scene, and those that it has instances of.
    struct Built {
        RTCScene world;
        std::vector<RTCScene> groups;
    };

    static SharedBuffers buffers_of(const SceneGeometry &geometry, const GeometrySpace &space);
    static void add(RTCScene scene, RTCGeometry added, RTCBuildQuality quality, SharedBuffers &shared, const Numbers &numbers);
    Built build(PeerScene &made);
    static void release(const Built &built);
    RTCScene new_scene(std::size_t space, bool robust, RTCBuildQuality quality);
    void add_instance(RTCScene world, RTCScene group, uint instance);

    const SceneGeometry &geometry_;
    RTCDevice device_;
    std::atomic<std::int64_t> allocated_ = 0;
    std::vector<SharedBuffers> buffers_;  ///< by space
    std::vector<PeerScene> list_;
    std::vector<Built> built_;
};

}  // namespace brandung
