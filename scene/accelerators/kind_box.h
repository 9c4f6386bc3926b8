/// What the binary build handles: boxes with the kinds as a fourth axis, and references that carry them.
#pragma once
#include <array>
#include <cfloat>

#include "scene/accelerators/accelerator.h"

namespace brandung {

constexpr uint axes = 4;
constexpr uint kind_axis = 3;

using Point4 = std::array<float, axes>;

/// Bounds in space, and from low[kind_axis] to high[kind_axis] in kinds: a mixture can be split there as in space.
/// The loops over four floats become one instruction each.
struct KindBox {
    Point4 low, high;

    static constexpr KindBox nothing() { return {{FLT_MAX, FLT_MAX, FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX, -FLT_MAX}}; }

    void add(Point4 other_low, Point4 other_high) {
        for (uint axis = 0; axis < axes; ++axis) {
            low[axis] = other_low[axis] < low[axis] ? other_low[axis] : low[axis];
            high[axis] = other_high[axis] > high[axis] ? other_high[axis] : high[axis];
        }
    }
    void add(const KindBox &other) { add(other.low, other.high); }
    bool empty() const { return low[0] > high[0]; }
    bool one_kind() const { return low[kind_axis] == high[kind_axis]; }
    uint kind() const { return uint(low[kind_axis]); }

    /// Half the centre: neither it nor a difference of two of them overflows.
    float half_centre(uint axis) const { return 0.25f * low[axis] + 0.25f * high[axis]; }
    Point4 half_centre() const { return {half_centre(0), half_centre(1), half_centre(2), half_centre(3)}; }

    /// Half the surface in space of the box grown by `pad`, which gives flat boxes, lines and points their due. In double nothing overflows.
    double half_area(double pad) const {
        const double x = double(high[0]) - low[0] + pad, y = double(high[1]) - low[1] + pad, z = double(high[2]) - low[2] + pad;
        return x * y + y * z + z * x;
    }
};

struct SortedReference {
    KindBox box;
    uint index;  ///< its place in the list that the builder was given
};

}  // namespace brandung
