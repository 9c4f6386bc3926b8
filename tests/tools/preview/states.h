/// States of renders for the tests of viewers.
#pragma once
#include "tools/preview/state.h"

namespace brandung {

/// Pixel i is (i, i / 1000, value).
inline std::shared_ptr<const Picture> test_picture(uint width, uint height, float value) {
    Picture picture{width, height, {}, {}};
    for (uint i = 0; i < width * height; ++i) picture.pixels.push_back({static_cast<float>(i), static_cast<float>(i) / 1000, value});
    return std::make_shared<const Picture>(std::move(picture));
}

inline SharedState test_state(std::shared_ptr<const Picture> picture, PreviewPhase phase = PreviewPhase::rendering) {
    PreviewState state;
    state.subject = {"scenes/a.json", "whitted", "wide_bvh", "a device", 300, 140, 4, 1000};
    state.phase = phase;
    state.progress.samples_done = 50, state.progress.samples_total = 200, state.progress.part = 0.5, state.progress.seconds = 1.5;
    state.progress.noise = Noise{.relmse = 0.25, .low = 0.125, .high = 0.5};
    state.samples_per_second = 40, state.rays_per_second = 100, state.seconds_left = 3.75;
    state.rays.rays = {50, 30, 20, 25}, state.rays.hits = {40, 10, 5, 1};
    state.kernels = {{"intersect", {3, 100, 7.5}}, {"shade", {3, 90, 2.5}}};
    state.steps = {{0, 50, {50}}, {1, 30, {0, 30}}, {0, 0, {0, 0}}};
    state.picture = std::move(picture);
    return std::make_shared<const PreviewState>(std::move(state));
}

}  // namespace brandung
