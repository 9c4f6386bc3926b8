#include "scene/accelerators/kd_split.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <vector>

#include "kernels/core/scene.h"

namespace brandung {
namespace {

using References = std::span<const KdReference>;

// In steps from node to node; so the SPD's scenes are traced fastest.
constexpr double list_cost = 2, reference_cost = 0.7;
constexpr double part_of_cost = 0.8;     ///< that counts where empty space is cut off
constexpr std::size_t exact_below = 65;  ///< references of a node for which all sides of boxes are tried
constexpr uint bins = 32;
constexpr std::size_t grain = 16384;  ///< references of a task

/// Costs of planes across one axis of a node.
class AxisCosts {
public:
    AxisCosts(const Bounds &box, int axis, double pad) : low_(box.low[axis]), high_(box.high[axis]), pad_(pad) {
        const auto extent = [&](int i) { return double(box.high[i]) - box.low[i] + pad; };
        const double a = extent((axis + 1) % 3), b = extent((axis + 2) % 3);
        base_ = a * b, slope_ = a + b;
        whole_ = half_area(extent(axis));
    }

    bool is_inside(float plane) const { return low_ < plane && plane < high_; }
    double of(float plane, std::size_t below, std::size_t above) const {
        const double sum =
            half_area(plane - low_ + pad_) / whole_ * kd_leaf_cost(below) + half_area(high_ - plane + pad_) / whole_ * kd_leaf_cost(above);
        return 1 + sum * (below == 0 || above == 0 ? part_of_cost : 1);
    }
    float plane_at(double part) const { return float(low_ + (high_ - low_) * part); }

private:
    double half_area(double extent) const { return base_ + slope_ * extent; }

    double low_, high_, pad_, base_, slope_, whole_;
};

struct Best {
    KdSplit split;
    double cost;

    void offer(const AxisCosts &costs, int axis, float plane, std::size_t below, std::size_t above) {
        if (!costs.is_inside(plane)) return;
        const double offered = costs.of(plane, below, above);
        if (offered < cost) *this = {{axis, plane}, offered};
    }
};

/// All planes through sides of boxes.
void try_all_sides(References references, const Bounds &box, double pad, Best &best) {
    const std::size_t n = references.size();
    std::vector<float> lows(n), highs(n);
    for (int axis = 0; axis < 3; ++axis) {
        const AxisCosts costs(box, axis, pad);
        for (std::size_t i = 0; i < n; ++i) lows[i] = references[i].low[axis], highs[i] = references[i].high[axis];
        std::ranges::sort(lows);
        std::ranges::sort(highs);
        for (std::size_t below = 0, ended = 0; below < n || ended < n;) {
            const float plane = below < n ? std::min(lows[below], highs[ended]) : highs[ended];
            while (ended < n && highs[ended] == plane) ++ended;
            best.offer(costs, axis, plane, below, n - ended);
            while (below < n && lows[below] == plane) ++below;
        }
    }
}

/// Of boxes along the three axes: how many begin and end in each bin, and between which planes all of them are.
struct Counts {
    std::array<std::array<uint, bins>, 3> begin{}, end{};
    Bounds box;

    void add(const Counts &other) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (uint bin = 0; bin < bins; ++bin) begin[axis][bin] += other.begin[axis][bin], end[axis][bin] += other.end[axis][bin];
        box.add(other.box);
    }
};

Counts count(References references, const Bounds &box) {
    const glm::dvec3 low = box.low, scale = double(bins) / (glm::dvec3(box.high) - low + DBL_MIN);
    const auto count_piece = [&](const tbb::blocked_range<std::size_t> &piece, Counts sum) {
        const auto bin = [&](float p, int axis) { return uint(std::clamp((p - low[axis]) * scale[axis], 0.0, bins - 1.0)); };
        for (const KdReference &reference : references.subspan(piece.begin(), piece.size())) {
            for (int axis = 0; axis < 3; ++axis) {
                ++sum.begin[size_t(axis)][bin(reference.low[axis], axis)];
                ++sum.end[size_t(axis)][bin(reference.high[axis], axis)];
            }
            sum.box.add({reference.low, reference.high});
        }
        return sum;
    };
    const auto join = [](Counts a, const Counts &b) {
        a.add(b);
        return a;
    };
    return tbb::parallel_reduce(tbb::blocked_range<std::size_t>(0, references.size(), grain), Counts{}, count_piece, join);
}

/// Planes between bins, and those that cut off empty space.
void try_bins(References references, const Bounds &box, double pad, Best &best) {
    const Counts counts = count(references, box);
    const std::size_t n = references.size();
    for (int axis = 0; axis < 3; ++axis) {
        const AxisCosts costs(box, axis, pad);
        best.offer(costs, axis, counts.box.low[axis], 0, n);
        best.offer(costs, axis, counts.box.high[axis], n, 0);
        std::size_t below = 0, above = n;
        for (uint bin = 0; bin + 1 < bins; ++bin) {
            below += counts.begin[size_t(axis)][bin], above -= counts.end[size_t(axis)][bin];
            best.offer(costs, axis, costs.plane_at((bin + 1.0) / bins), below, above);
        }
    }
}

/// Whether a plane leaves either side less than all.
bool separates(References references, int axis, float plane) {
    const auto is_below = [&](const KdReference &reference) { return reference.is_below(axis, plane); };
    const auto is_above = [&](const KdReference &reference) { return reference.is_above(axis, plane); };
    return !std::ranges::all_of(references, is_below) && !std::ranges::all_of(references, is_above);
}

/// Middle of the references' centres in the box.
float median(References references, const Bounds &box, int axis) {
    std::vector<float> centres(references.size());
    std::ranges::transform(references, centres.begin(), [&](const KdReference &reference) {
        return 0.5f * std::max(reference.low[axis], box.low[axis]) + 0.5f * std::min(reference.high[axis], box.high[axis]);
    });
    const auto middle = centres.begin() + std::ptrdiff_t(centres.size() / 2);
    std::nth_element(centres.begin(), middle, centres.end());
    return *middle;
}

}  // namespace

double kd_leaf_cost(std::size_t references) { return references == 0 ? 0 : list_cost + reference_cost * double(references); }

KdSplit cheapest_split(References references, const Bounds &box, double pad) {
    Best best{.split = {}, .cost = kd_leaf_cost(references.size())};
    if (references.size() < exact_below)
        try_all_sides(references, box, pad, best);
    else
        try_bins(references, box, pad, best);
    return best.split;
}

KdSplit median_split(References references, const Bounds &box, double) {
    if (references.size() <= BLOCK_SIZE) return {};
    std::array<int, 3> axes = {0, 1, 2};
    std::ranges::stable_sort(axes, std::greater(), [&](int axis) { return double(box.high[axis]) - box.low[axis]; });
    for (const int axis : axes) {
        const float plane = median(references, box, axis);
        if (box.low[axis] < plane && plane < box.high[axis] && separates(references, axis, plane)) return {axis, plane};
    }
    return {};
}

}  // namespace brandung
