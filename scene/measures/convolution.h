/// Separable filters over pictures of four channels.
#pragma once
#include <array>
#include <vector>

#include "kernels/core/portable.h"

namespace brandung {

/// Four values per pixel, row by row from the top.
struct Planes {
    uint width = 0, height = 0;
    std::vector<glm::dvec4> pixels;
};

/// Weights of the places -radius to radius.
using Weights = std::vector<double>;
/// Those of each channel; all of one radius.
using ChannelWeights = std::array<Weights, 4>;

/// exp(-place^2 / (2 sigma^2)), not normalised; sigma in pixels.
Weights gaussian(int radius, double sigma);
/// The same weights, scaled to a sum of 1.
Weights normalized(Weights weights);

/// The sum over i and j of horizontal[i] vertical[j] planes(x + i, y + j), so weights are not mirrored; beyond its edges a picture goes on as it is
/// there.
Planes filtered(const Planes &planes, const ChannelWeights &horizontal, const ChannelWeights &vertical);

}  // namespace brandung
