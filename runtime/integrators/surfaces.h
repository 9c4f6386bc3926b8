/// Surfaces: from a wave's rays to the points where they meet the scene, as every integrator begins.
#pragma once
#include <optional>

#include "runtime/integrators/integrator.h"
#include "runtime/integrators/stages.h"
#include "runtime/wavefront/levels.h"

namespace brandung {

class Surfaces {
public:
    /// `bounces`: whether there are rays beyond those of the camera. `tallies`: work-items of the largest launch of a tracing stage.
    Surfaces(const IntegratorJob &job, bool bounces, std::size_t tallies);

    /// Side arrays of camera rays, before the rays themselves are generated: all of a batch begin in the media that the eye is in.
    void start(Level &first, const Batch &batch);
    /// Whether the wave's rays are traced as such that do.
    bool stay_together(const Wave &wave) const { return are_coherent(wave.generation, paths_); }
    /// Fills the arrays below for a wave's rays; tells the batch's AOVs of what camera rays meet.
    void find(const Wave &wave, const Batch &batch);

    const Buffer<Tints> &tints() const { return pictures ? pictures->tints : no_tints; }
    const Buffer<uint> &beyond() const { return media ? media->beyond : no_words; }
    /// An array that has an entry for each place of an item's list of media.
    Access in_lists(const Buffer<uint> &buffer) const { return several(buffer, interior_size_); }
    /// One of instances, which holds times too where some move.
    Access in_places(const Buffer<uint> &buffer) const { return several(buffer, place_words); }
    Access places() const { return in_places(hit_instances); }
    uint interior_size() const { return interior_size_; }
    std::uint64_t media_lost() const { return media ? media->lost.read().at(0) : 0; }
    std::size_t bytes() const;
    /// The stages that the scene does without.
    void add_skipped(std::vector<Skipped> &skipped) const;

    uint place_words;  ///< of a ray or hit in arrays of instances; 0 where the scene has none
    Buffer<Hit> hits;
    Buffer<uint> hit_instances;  ///< of the hits, in scenes with instances
    Buffer<SurfacePoint> points;
    Buffer<SurfaceInterface> interfaces;
    Buffer<vec3> directions;        ///< back along the rays
    Buffer<std::uint8_t> no_bytes;  ///< these stand for arrays that the scene does without
    Buffer<uint> no_words;
    Buffer<float> no_floats;
    Buffer<Tints> no_tints;
    RayCounter counter;
    std::optional<Interfaces> media;
    std::optional<Choices> choices;
    std::optional<Grouping> grouping;
    std::optional<Pictures> pictures;

private:
    void trace(const Wave &wave);

    const DeviceScene &scene_;
    uint interior_size_;
    bool paths_;
    bool several_kinds_;  ///< of BSDFs, which paths meet
    Kernel evaluate_, intersect_together_;
    std::optional<Kernel> intersect_apart_;
};

}  // namespace brandung
