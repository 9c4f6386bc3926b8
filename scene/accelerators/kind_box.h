/// What the binary build handles: boxes with the kinds as a fourth axis, and references that carry them.
#pragma once
#include <algorithm>
#include <array>
#include <cfloat>

#include "scene/accelerators/accelerator.h"

namespace brandung {

constexpr uint axes = 4;
constexpr uint kind_axis = 3;

/// Four floats to which one instruction applies; they need no alignment.
typedef float Point4 __attribute__((vector_size(4 * axes), aligned(4)));

/// Bounds in space, and from low[kind_axis] to high[kind_axis] in kinds: a mixture can be split there as in space.
struct KindBox {
    Point4 low, high;

    static constexpr KindBox nothing() { return {Point4{} + FLT_MAX, Point4{} - FLT_MAX}; }

    void add(Point4 other_low, Point4 other_high) {
        low = other_low < low ? other_low : low;
        high = other_high > high ? other_high : high;
    }
    void add(const KindBox &other) { add(other.low, other.high); }
    bool operator==(const KindBox &other) const {
        for (uint axis = 0; axis < axes; ++axis)
            if (low[axis] != other.low[axis] || high[axis] != other.high[axis]) return false;
        return true;
    }
    bool one_kind() const { return low[kind_axis] == high[kind_axis]; }
    uint kind() const { return uint(low[kind_axis]); }

    /// Half the centre: neither it nor a difference of two of them overflows.
    float half_centre(uint axis) const { return 0.25f * low[axis] + 0.25f * high[axis]; }
    Point4 half_centre() const { return 0.25f * low + 0.25f * high; }
};

/// Surfaces of boxes, relative to what holds them all: in float they neither overflow nor vanish.
class RelativeArea {
public:
    RelativeArea() = default;
    explicit RelativeArea(const KindBox &all) {
        float half = 0x1p-84f;
        for (uint axis = 0; axis < kind_axis; ++axis) half = std::max(half, 0.5f * all.high[axis] - 0.5f * all.low[axis]);
        scale_ = 1 / half;
    }
    /// Half the surface in space of the box grown by a pad, which gives flat boxes, lines and points their due. The unit is the square of the longest
    /// edge of all.
    float operator()(const KindBox &box) const {
        const Point4 size = (0.5f * box.high - 0.5f * box.low) * scale_ + pad;
        return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
    }

private:
    static constexpr float pad = 0x1p-40f;  ///< far below what a float can resolve of the scene, but enough to tell short lines from long ones

    float scale_ = 0;
};

struct SortedReference {
    KindBox box;
    uint index;  ///< its place in the list that the builder was given
};

}  // namespace brandung
