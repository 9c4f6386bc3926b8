/// WaveObserver: is shown what an integrator's stages have read and written, wave by wave. Renders have none, and then no record is made.
#pragma once
#include <vector>

#include "kernels/core/items.h"
#include "kernels/stages/describe_paths.h"

namespace brandung {

/// Rays that a wave's rays may spawn, one per ray, whether it lives or not: of one kind, or of the kind that was chosen.
struct ChildRecords {
    std::vector<Ray> rays;
    std::vector<Spectrum> weights;  ///< their throughput where that of the parent is 1
    std::vector<std::uint8_t> alive;
    std::vector<NextDescription> chosen;  ///< of paths: how; else empty
};

/// The shadow rays of one row of a launch, each to a light or to a stratum of an emissive shape, one per ray of the wave.
struct LightRecords {
    std::vector<uint> rows;  ///< of the scene's lights, see LightRows
    std::vector<Ray> rays;
    std::vector<std::uint8_t> asked, visible;
    std::vector<Spectrum> filters;         ///< what arrives of the light where it is visible; empty where shadows are not filtered
    std::vector<Spectrum> radiance;        ///< towards the eye at throughput 1; where it is not visible, that which something is in the way of
    std::vector<AskedDescription> chosen;  ///< of paths: the light; else empty
};

/// Lights whose shares are added before they are rounded to fixed point.
struct LightBlockRecords {
    std::vector<LightRecords> lights;
    std::vector<Spectrum> contributions;  ///< as accumulated; those of the first block contain what needs no light
};

/// A wave of rays; item i of every vector is that of the wave's ray i.
struct WaveRecords {
    uint generation = 0;
    bool coherent = true;      ///< whether its rays are traced as such that stay together
    uint base = 0;             ///< child j of ray i goes to slot base + j * count + i of the next generation
    std::vector<uint> slots;   ///< of the rays, in their generation
    std::vector<uint> traced;  ///< the rays in the order in which they were traced, which stages behind may change
    std::vector<Ray> begun;    ///< as spawned
    std::vector<Ray> rays;     ///< as they met their hits: where faces were no interfaces, from behind them on
    std::vector<Path> paths;
    std::vector<Hit> hits;                         ///< of `rays`
    std::vector<uint> instances, begun_instances;  ///< of `hits`, and of the primitives that `begun` leave: 0 outside of all
    std::vector<float> times;                      ///< of the rays, where instances move; else empty
    std::vector<SurfacePoint> points;
    std::vector<SurfaceInterface> interfaces;
    std::vector<vec3> directions;        ///< back along the rays
    uint interior_size = 0;              ///< entries per ray of the next three, as kernels/core/interior.cl has them
    std::vector<uint> begun_media;       ///< where `begun` begin
    std::vector<uint> before, behind;    ///< media on both sides of the hits
    std::vector<Tints> tints;            ///< empty in scenes without
    std::vector<Spectrum> unlit;         ///< radiance that needs no light
    std::vector<MetDescription> met;     ///< of paths: what that is, and its weight; else empty
    std::vector<ChildRecords> children;  ///< those of every ray may be mirrored, then refracted, or one of both; as many as the scene needs;
                                         ///< of paths: as many as the largest bundle has
    std::vector<LightBlockRecords> lights;
    std::size_t count() const { return slots.size(); }
};

class WaveObserver {
public:
    virtual ~WaveObserver() = default;
    /// Called when the wave's children are known, before any wave that they are in.
    virtual void see(const WaveRecords &wave) = 0;
    /// Whether it asks what single rays and their lights add, and why. Else waves may lack unlit, met, contributions, children, and of lights rows,
    /// visible, radiance and chosen.
    virtual bool explains() const { return false; }
    /// Called after the batch's last wave with the sums of all contributions, by sample.
    virtual void end(const std::vector<Sample> &sums) = 0;
};

}  // namespace brandung
