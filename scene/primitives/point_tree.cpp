#include "scene/primitives/point_tree.h"

#include <algorithm>

namespace brandung {

PointTree::PointTree(std::vector<Point> points, uint numbers) : points_(std::move(points)), nodes_(points_.size()), place_of_(numbers, nowhere) {
    arrange(all());
    for (uint i = 0; i < points_.size(); ++i) place_of_[points_[i].number] = i;
}

void PointTree::arrange(Range range) {
    if (range.first == range.last) return;
    const auto first = points_.begin() + range.first, last = points_.begin() + range.last;
    Node &node = nodes_[range.middle()] = {first->place, first->place, range.last - range.first};
    for (auto point = first; point != last; ++point) node.low = glm::min(node.low, point->place), node.high = glm::max(node.high, point->place);
    const auto less = [axis = range.axis](const Point &a, const Point &b) { return a.place[axis] < b.place[axis]; };
    std::nth_element(first, points_.begin() + range.middle(), last, less);
    arrange(range.before());
    arrange(range.after());
}

void PointTree::remove(uint number) {
    const uint place = place_of_[number];
    if (place == nowhere) return;
    place_of_[number] = nowhere;
    Range range = all();
    for (; range.middle() != place; range = place < range.middle() ? range.before() : range.after()) --nodes_[range.middle()].left;
    --nodes_[place].left;
}

}  // namespace brandung
