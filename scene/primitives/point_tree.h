/// PointTree: points of the plane, searched by region and taken out one by one.
#pragma once
#include <vector>

#include "kernels/core/portable.h"

namespace brandung {

/// A k-d tree (Bentley 1975) without pointers: the point in the middle of a range divides it, along x and y in turns.
class PointTree {
public:
    struct Point {
        glm::dvec2 place;
        uint number;
    };

    PointTree() = default;
    /// Points have different numbers, below `numbers`.
    PointTree(std::vector<Point> points, uint numbers);

    /// Takes out the point of that number, if it is there.
    void remove(uint number);

    /// Whether `holds(number)` for a point that is there. Boxes (lowest, highest corner) are left out unless `may_hold(low, high)` for a point in
    /// them.
    template <class MayHold, class Holds> bool any(const MayHold &may_hold, const Holds &holds) const { return any_in(all(), may_hold, holds); }

private:
    /// Points first ... last - 1, divided along the axis.
    struct Range {
        uint first, last;
        int axis;
        uint middle() const { return (first + last) / 2; }
        Range before() const { return {first, middle(), 1 - axis}; }
        Range after() const { return {middle() + 1, last, 1 - axis}; }
    };
    /// What is known of a range, at its middle.
    struct Node {
        glm::dvec2 low, high;  ///< box of all its points
        uint left;             ///< how many are there
    };
    static constexpr uint nowhere = 0xffffffffu;

    Range all() const { return {0, static_cast<uint>(points_.size()), 0}; }
    void arrange(Range range);

    template <class MayHold, class Holds> bool any_in(Range range, const MayHold &may_hold, const Holds &holds) const {
        if (range.first == range.last) return false;
        const Node &node = nodes_[range.middle()];
        if (node.left == 0 || !may_hold(node.low, node.high)) return false;
        const uint number = points_[range.middle()].number;
        return (place_of_[number] != nowhere && holds(number)) || any_in(range.before(), may_hold, holds) || any_in(range.after(), may_hold, holds);
    }

    std::vector<Point> points_;
    std::vector<Node> nodes_;
    std::vector<uint> place_of_;  ///< by number
};

}  // namespace brandung
