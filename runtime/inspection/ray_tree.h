/// Trees of rays: what happened to a sample between eye and lights, from the records of its waves.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "kernels/stages/describe_hits.h"
#include "kernels/stages/describe_lights.h"
#include "kernels/stages/face_list.h"
#include "runtime/integrators/wave_observer.h"

namespace brandung {

/// A shadow ray to a light or to a stratum of an emissive shape, and what that adds.
struct TracedLight {
    uint row;  ///< of the scene's lights, see LightRows
    Ray ray;
    bool asked;                              ///< the ray was traced
    bool visible;                            ///< and light arrives along it
    LightDescription description;            ///< by describe_hits(), where it was not asked; of paths: always
    std::optional<AskedDescription> chosen;  ///< of paths
    Hit blocker;                             ///< by describe_hits(), where it is not visible: the closest thing in its way; of filtered shadows, by
                                             ///< list_faces(), that which takes the last of the light
    uint blocker_instance = 0;               ///< that it is in, 0 outside of all
    std::optional<Spectrum> filter;          ///< the part of the light that arrives; none where shadows are not filtered, and where it was not asked
    std::vector<PassedFace> passed;          ///< what lets that part through, in order; by list_faces()
    Spectrum radiance;                       ///< towards the eye at throughput 1; where it is not visible, that which something is in the way of
};

/// Lights whose shares were added before they were rounded to fixed point.
struct TracedLightBlock {
    std::vector<TracedLight> lights;
    Spectrum contribution;  ///< to the sample
};

struct TracedRay;

/// A ray that a hit may spawn.
struct TracedChild {
    Ray ray;
    Spectrum weight;                        ///< of its radiance in that of the parent
    std::unique_ptr<TracedRay> traced;      ///< null if it was not spawned
    std::optional<NextDescription> chosen;  ///< of paths
};

struct TracedRay {
    Path path;
    Ray begun;  ///< as spawned
    Ray ray;    ///< as it met its hit: where it passed faces that are no interfaces, from behind the last of them on
    Hit hit;
    uint instance = 0;               ///< that the hit is in, 0 outside of all
    uint begun_instance = 0;         ///< that of the primitive which `begun` leaves
    std::vector<uint> begun_media;   ///< where `begun` begins, as `before`
    std::vector<PassedFace> passed;  ///< the faces between `begun` and `ray`, in order; by list_faces()
    SurfacePoint point;
    SurfaceInterface interface;
    vec3 direction;                     ///< back along the ray
    std::vector<uint> before, behind;   ///< lists of media, as kernels/core/interior.cl has them
    HitDescription description{};       ///< by describe_hits(), where something was hit
    std::optional<Tints> tints;         ///< none in scenes without
    std::optional<float> time;          ///< none where no instance moves
    Spectrum unlit;                     ///< radiance that needs no light
    std::optional<MetDescription> met;  ///< of paths: what that is, and its weight
    std::vector<TracedLightBlock> lights;
    std::vector<TracedChild> children;  ///< the mirrored ray, then the refracted one, as far as the scene needs them; or the one that was chosen;
                                        ///< of paths: the parts of the bundle

    bool passed_faces() const { return begun.origin != ray.origin; }
    bool hits() const { return hit.primitive != NO_HIT; }
};

/// Builds the tree of every sample of a batch.
class RayTrees : public WaveObserver {
public:
    explicit RayTrees(uint samples);
    void see(const WaveRecords &wave) override;
    bool explains() const override { return true; }
    void end(const std::vector<Sample> &sums) override { sums_ = sums; }

    /// By the sample's place in the batch; complete after the batch.
    std::vector<TracedRay> &trees() { return trees_; }
    /// Of their contributions, as the device has added them up.
    const std::vector<Sample> &sums() const { return sums_; }

private:
    std::vector<TracedRay> trees_;
    std::vector<Sample> sums_;
    std::vector<std::vector<TracedRay *>> waiting_;  ///< by generation and slot: what a ray is to become
};

/// Adds to an array of instances, as kernels read it, what is in this one at the ray's time.
void add_place(std::vector<uint> &places, uint instance, const TracedRay &ray);

/// Of the surface where the ray ends, on its way from the eye, from 1 on.
uint surface_number(const TracedRay &ray);
/// The `number`-th part, from 0 on, of `count`.
struct SamplePart {
    uint number, count;
};
/// Which part of its sample a path is: 0 of 1 where there are no bundles, and before the surface that the eye sees.
SamplePart part_of_sample(const TracedRay &ray);

/// All rays of trees.
std::vector<TracedRay *> all_rays(std::vector<TracedRay> &trees);
/// visit(ray, light) for every light of these rays.
template <class Visit> void for_each_light(const std::vector<TracedRay *> &rays, const Visit &visit) {
    for (TracedRay *ray : rays)
        for (TracedLightBlock &block : ray->lights)
            for (TracedLight &light : block.lights) visit(*ray, light);
}

/// A contribution as it is added to a sample: per channel, in units of 2^-32. Nothing of one that is not finite is.
using FixedPoint = std::array<std::int64_t, 3>;
FixedPoint fixed_point(Spectrum contribution);

}  // namespace brandung
