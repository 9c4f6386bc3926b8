/// Polygons into triangles by clipping ears, those with the shortest diagonal first: few slivers, and small boxes for accelerators.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

#include "scene/primitives/point_tree.h"
#include "scene/primitives/shape.h"
#include "scene/vectors.h"

namespace brandung {
namespace {

/// A vertex in the ring of those that are not clipped yet.
struct Corner {
    double x, y;          ///< in the plane; they are floats, so that products are exact
    uint previous, next;  ///< places in the ring
    bool in_ring = true;
    bool convex = false;
};

/// The sum's leading part: its sign is that of the exact sum (Shewchuk 1997, expansions).
double exact_sum(const std::array<double, 6> &terms) {
    std::array<double, 6> parts;  // do not overlap, ascending
    std::size_t count = 0;
    for (double sum : terms) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const double large = std::abs(sum) < std::abs(parts[i]) ? parts[i] : sum;
            const double small = std::abs(sum) < std::abs(parts[i]) ? sum : parts[i];
            sum = large + small;
            const double lost = small - (sum - large);
            if (lost != 0) parts[kept++] = lost;
        }
        if (sum != 0) parts[kept++] = sum;
        count = kept;
    }
    return count == 0 ? 0 : parts[count - 1];
}

/// Twice the area of abc with an exact sign: positive if counterclockwise.
double orientation(const Corner &a, const Corner &b, const Corner &c) {
    const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
    const double error = 4 * std::numeric_limits<double>::epsilon() * (std::abs(left) + std::abs(right));
    if (std::abs(left - right) > error) return left - right;
    return exact_sum({a.x * b.y, -a.y * b.x, b.x * c.y, -b.y * c.x, c.x * a.y, -c.y * a.x});
}

bool same_place(const Corner &a, const Corner &b) { return a.x == b.x && a.y == b.y; }

/// Whether a box reaches to the left of the line from a to b, or to the line.
bool reaches(glm::dvec2 low, glm::dvec2 high, const Corner &a, const Corner &b) {
    const Corner leftmost{a.y < b.y ? low.x : high.x, a.x < b.x ? high.y : low.y, 0, 0};
    return orientation(a, b, leftmost) >= 0;
}

class EarClipper {
public:
    explicit EarClipper(const std::vector<vec3> &polygon) : polygon_(polygon) {}

    std::vector<uint> run() {
        triangles_.reserve(3 * polygon_.size());
        project();
        remove_corners([this](uint i) { return same_place(corners_[i], corners_[corners_[i].next]) || is_spike(i); });
        clip_ears();
        // What is left is not a simple polygon. Without its straight corners it may be; else corners are clipped whatever lies in them.
        while (left_ > 2 && remove_corners([this](uint i) { return turn(i) == 0; })) clip_ears();
        ignore_blockers_ = true;
        if (left_ > 2) clip_ears();
        return std::move(triangles_);
    }

private:
    /// A corner that was an ear when its neighbours were these.
    struct Ear {
        double diagonal;  ///< squared length
        uint corner, previous, next;
        bool operator<(const Ear &other) const { return std::tie(diagonal, corner) > std::tie(other.diagonal, other.corner); }
    };

    /// Leaves out the axis along which the polygon is seen best; counterclockwise stays so.
    void project() {
        const glm::dvec3 area = area_vector(polygon_), size = glm::abs(area);
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const int x = (axis + (area[axis] > 0 ? 1 : 2)) % 3, y = 3 - axis - x;
        left_ = uint(polygon_.size());
        corners_.resize(left_);
        for (uint i = 0; i < left_; ++i) corners_[i] = {polygon_[i][x], polygon_[i][y], (i + left_ - 1) % left_, (i + 1) % left_};
    }

    double turn(uint i) const { return orientation(corners_[corners_[i].previous], corners_[i], corners_[corners_[i].next]); }

    void remove(uint i) {
        Corner &corner = corners_[i];
        corners_[corner.previous].next = corner.next;
        corners_[corner.next].previous = corner.previous;
        corner.in_ring = false;
        --left_;
    }

    /// Whether the polygon turns back on itself at the corner.
    bool is_spike(uint i) const {
        const Corner &a = corners_[corners_[i].previous], &b = corners_[i], &c = corners_[corners_[i].next];
        return (a.x - b.x) * (c.x - b.x) + (a.y - b.y) * (c.y - b.y) > 0 && turn(i) == 0;
    }

    /// Removes all corners that the condition holds for, those included that it comes to hold for.
    template <class Condition> bool remove_corners(Condition condition) {
        const uint before = left_;
        for (uint i = 0; i < corners_.size(); ++i) {
            for (uint k = i; left_ > 2 && corners_[k].in_ring && condition(k); k = corners_[k].previous) remove(k);
        }
        return left_ < before;
    }

    /// Clips ears while there are any. Only the neighbours of a clipped ear can become ears: the corner that lies deepest in a blocked one is not
    /// convex.
    void clip_ears() {
        std::priority_queue<Ear> ears;
        for (uint i = 0; i < corners_.size(); ++i) corners_[i].convex = corners_[i].in_ring && turn(i) > 0;
        find_blockers();
        for (uint i = 0; i < corners_.size(); ++i) add_if_ear(i, ears);
        while (left_ > 2 && !ears.empty()) {
            const Ear ear = ears.top();
            ears.pop();
            const Corner &corner = corners_[ear.corner];
            if (!corner.in_ring || corner.previous != ear.previous || corner.next != ear.next) continue;
            triangles_.insert(triangles_.end(), {ear.previous, ear.corner, ear.next});
            remove(ear.corner);
            for (const uint i : {ear.previous, ear.next}) {
                corners_[i].convex = turn(i) > 0;
                if (corners_[i].convex) blockers_.remove(i);
            }
            for (const uint i : {ear.previous, ear.next}) add_if_ear(i, ears);
        }
    }

    void add_if_ear(uint i, std::priority_queue<Ear> &ears) const {
        const Corner &corner = corners_[i];
        if (!corner.in_ring || !corner.convex || (!ignore_blockers_ && blocked(corner))) return;
        const glm::dvec3 diagonal = glm::dvec3(polygon_[corner.next]) - glm::dvec3(polygon_[corner.previous]);
        ears.push({glm::dot(diagonal, diagonal), i, corner.previous, corner.next});
    }

    /// The corners that may lie in ears. Clipping makes angles smaller, so that none is added later.
    void find_blockers() {
        std::vector<PointTree::Point> blockers;
        for (uint i = 0; i < corners_.size(); ++i) {
            if (corners_[i].in_ring && !corners_[i].convex) blockers.push_back({{corners_[i].x, corners_[i].y}, i});
        }
        blockers_ = PointTree(std::move(blockers), uint(corners_.size()));
    }

    /// Whether a corner of the ring lies in the ear, its diagonal included.
    bool blocked(const Corner &b) const {
        const Corner &a = corners_[b.previous], &c = corners_[b.next];
        const auto [left, right] = std::minmax({a.x, b.x, c.x});
        const auto [bottom, top] = std::minmax({a.y, b.y, c.y});
        const auto may_block = [&, left = left, right = right, bottom = bottom, top = top](glm::dvec2 low, glm::dvec2 high) {
            return low.x <= right && high.x >= left && low.y <= top && high.y >= bottom && reaches(low, high, a, b) && reaches(low, high, b, c) &&
                   reaches(low, high, c, a);
        };
        return blockers_.any(may_block, [&](uint i) {
            const Corner &p = corners_[i];
            return !same_place(p, a) && !same_place(p, b) && !same_place(p, c) && orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 &&
                   orientation(c, a, p) >= 0;
        });
    }

    const std::vector<vec3> &polygon_;
    std::vector<Corner> corners_;
    PointTree blockers_;
    std::vector<uint> triangles_;
    uint left_ = 0;
    bool ignore_blockers_ = false;
};

}  // namespace

std::vector<uint> triangulate(const std::vector<vec3> &polygon) {
    if (polygon.size() < 3 || area_vector(polygon) == glm::dvec3(0)) return {};
    if (polygon.size() == 3) return {0, 1, 2};
    return EarClipper(polygon).run();
}

}  // namespace brandung
