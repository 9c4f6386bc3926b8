/// EmbreePeer: the same scene and rays, traced by Embree 3, where the program was built with it.
#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "runtime/accelerators/ray_tracing.h"
#include "tools/bench/scene_geometry.h"

namespace brandung {

/// One of Embree's structures for a scene.
struct PeerScene {
    const char *name;  ///< medium, high: Embree's default, by the quality of the build; robust: its scene flag, at medium quality
    bool high, robust;
    std::vector<double> build_seconds = {};  ///< of each time that it was built
    std::size_t bytes = 0;                   ///< that Embree has allocated for it
};

/// One of Embree's functions for tracing: rtcIntersect1, 4, 8 or 16, or rtcOccluded1 ..., with a flag of its context.
struct PeerApi {
    uint width;
    bool coherent;
    std::string name() const { return std::to_string(width) + (coherent ? " coherent" : " incoherent"); }
};
inline constexpr std::array<PeerApi, 8> peer_apis = {{{1, false}, {1, true}, {4, false}, {4, true}, {8, false}, {8, true}, {16, false}, {16, true}}};

class EmbreePeer {
public:
    /// Throws Error where it is not built in.
    static void check_built_in();
    /// Which primitives of the scene Embree has not; empty if it has all.
    static std::string refusal(const SceneGeometry &geometry);
    /// Builds all scenes, of such a geometry, which must live as long. Throws Error if it fails, as where it is not built in.
    EmbreePeer(const SceneGeometry &geometry, uint threads);
    ~EmbreePeer();

    /// "3.13.5"
    std::string version() const;
    /// The widest packets that it traces as such on this machine: 4, 8 or 16.
    uint native_width() const;
    /// The instructions it was made for that this processor has, as far as its width and the processor tell, for it keeps its choice to itself:
    /// "AVX-512", "AVX2", "AVX" or "SSE".
    std::string instructions() const;
    /// Builds all scenes once more, for their times.
    void build_again();
    const std::vector<PeerScene> &scenes() const;
    /// Rays for trace(), which must live as long.
    void take(const RaySpan &rays);
    /// Whether Embree comes back. rtcOccluded16 of 3.13.5 with the flag for coherent rays does not in the example mesh.json, whose world has
    /// triangles and instances of triangles that are scaled: for sixteen shadow rays, all valid, finite and of one octant, each of which rtcOccluded1
    /// answers. A grid of triangles, with and without instances of itself, has not shown it; what makes the difference is not known.
    bool can_trace(const PeerApi &api, bool any) const;
    /// All of them; gives the time that it took [s].
    double trace(std::size_t scene, const PeerApi &api);
    /// What the last trace() has found.
    RayAnswers answers() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace brandung
