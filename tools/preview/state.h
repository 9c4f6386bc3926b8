/// PreviewState: a render at one moment, as those who watch it see it. Never changed once it is made, so that threads can share it.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/renderer.h"
#include "scene/image.h"

namespace brandung {

/// What is rendered, and on what.
struct PreviewSubject {
    std::string scene, integrator, accelerator, device;
    uint width = 0, height = 0, spp = 0;
    uint batch = 0;           ///< rays per wave
    PictureStyle style = {};  ///< of pictures of 8 bits
};

enum class PreviewPhase { preparing, rendering, done, interrupted, failed };

struct PreviewState {
    PreviewSubject subject;
    PreviewPhase phase = PreviewPhase::preparing;
    std::string doing;  ///< what is being prepared
    RenderProgress progress;
    std::optional<double> samples_per_second, rays_per_second, seconds_left;
    RayCounts rays;
    Profile kernels;
    std::vector<WaveStep> steps;  ///< the last ones of the integrator's loop, oldest first
    /// The latest picture that somebody wanted; a new one is another object. Null before the first.
    std::shared_ptr<const Picture> picture;

    /// Nothing will change any more.
    bool ended() const { return phase != PreviewPhase::preparing && phase != PreviewPhase::rendering; }
};
using SharedState = std::shared_ptr<const PreviewState>;

}  // namespace brandung
