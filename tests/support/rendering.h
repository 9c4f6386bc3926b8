/// Whole renders.
#pragma once
#include <vector>

#include "runtime/renderer.h"

namespace brandung {

struct Rendering {
    std::vector<FilmPixel> film;
    std::vector<vec3> picture;
    RayCounts counts;
    std::uint64_t refused, media_lost;
    uint clamped;
};

__int128 value_of(Integer128 x);
/// The sum of all samples of channel c.
__int128 sum_of(const FilmPixel &pixel, std::size_t c);
/// The sum of their squares.
__int128 squares_of(const FilmPixel &pixel, std::size_t c);

/// Renders with the scene's first camera on the test device.
Rendering render_scene(const Scene &scene, const RenderOptions &options = {}, Kinds kinds = Kinds::in_use);
/// On another one.
Rendering render_scene(Device &device, const Scene &scene, const RenderOptions &options = {}, Kinds kinds = Kinds::in_use);

/// Of the exact sums: equal pictures and only they have equal hashes (FNV-1a, 64 bits).
std::uint64_t film_hash(const std::vector<FilmPixel> &film);
/// Expects that neither batches, nor kernels made for more than the scene has, nor accelerators change a bit of the film. Leaves another accelerator.
void expect_same_bits(Scene &scene);

}  // namespace brandung
