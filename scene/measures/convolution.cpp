#include "scene/measures/convolution.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace brandung {
namespace {

using glm::dvec4;

std::vector<dvec4> side_by_side(const ChannelWeights &weights) {
    std::vector<dvec4> all(weights[0].size());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = dvec4(weights[0][k], weights[1][k], weights[2][k], weights[3][k]);
    return all;
}

/// A row of pixels with `radius` more at both ends.
std::vector<dvec4> extended_row(const Planes &planes, uint y, std::size_t radius) {
    const auto begin = planes.pixels.begin() + std::ptrdiff_t(std::size_t(y) * planes.width);
    std::vector<dvec4> row(radius, *begin);
    row.insert(row.end(), begin, begin + planes.width);
    row.insert(row.end(), radius, row.back());
    return row;
}

void filter_row(const std::vector<dvec4> &extended, const std::vector<dvec4> &weights, dvec4 *out, uint width) {
    for (std::size_t k = 0; k < weights.size(); ++k)
        for (uint x = 0; x < width; ++x) out[x] += weights[k] * extended[x + k];
}

/// Adds the rows round y to `out`, weighted.
void filter_columns(const Planes &planes, uint y, const std::vector<dvec4> &weights, dvec4 *out) {
    const std::int64_t radius = std::int64_t(weights.size() / 2);
    for (std::int64_t k = -radius; k <= radius; ++k) {
        const std::int64_t row = std::clamp<std::int64_t>(y + k, 0, planes.height - 1);
        const dvec4 *in = &planes.pixels[std::size_t(row) * planes.width];
        const dvec4 weight = weights[std::size_t(k + radius)];
        for (uint x = 0; x < planes.width; ++x) out[x] += weight * in[x];
    }
}

}  // namespace

Weights gaussian(int radius, double sigma) {
    Weights weights;
    for (int place = -radius; place <= radius; ++place) weights.push_back(std::exp(-0.5 * (place / sigma) * (place / sigma)));
    return weights;
}

Weights normalized(Weights weights) {
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (double &weight : weights) weight /= sum;
    return weights;
}

Planes filtered(const Planes &planes, const ChannelWeights &horizontal, const ChannelWeights &vertical) {
    const auto across = side_by_side(horizontal), down = side_by_side(vertical);
    const std::vector<dvec4> black(planes.pixels.size(), dvec4(0));
    Planes rows{planes.width, planes.height, black}, result = rows;
    tbb::parallel_for(uint(0), planes.height, [&](uint y) {
        filter_row(extended_row(planes, y, across.size() / 2), across, &rows.pixels[std::size_t(y) * planes.width], planes.width);
    });
    tbb::parallel_for(uint(0), planes.height, [&](uint y) { filter_columns(rows, y, down, &result.pixels[std::size_t(y) * planes.width]); });
    return result;
}

}  // namespace brandung
