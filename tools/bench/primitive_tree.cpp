#include "tools/bench/primitive_tree.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace brandung {
namespace {

using glm::dvec3;

constexpr std::size_t most_in_leaf = 8, least_in_task = 4096;

}  // namespace

PrimitiveTree::PrimitiveTree(const SceneGeometry &geometry, const GeometrySpace &space) : geometry_(geometry), numbers_(space.end - space.first) {
    std::iota(numbers_.begin(), numbers_.end(), space.first);
    while (numbers_.size() >> levels_ > most_in_leaf) ++levels_;
    boxes_.resize((std::size_t{2} << levels_) - 1);
    if (!numbers_.empty()) build({0, 0, numbers_.size(), 0});
}

PrimitiveTree::Box PrimitiveTree::box_of(const GeometryPrimitive &primitive) {
    if (primitive.kind == GeometryPrimitive::Kind::sphere) {
        // Their sums are rounded by less than what boxes are grown by.
        const vec3 radius(std::abs(primitive.b.x));
        return {primitive.a - radius, primitive.a + radius};
    }
    return {glm::min(primitive.a, glm::min(primitive.b, primitive.c)), glm::max(primitive.a, glm::max(primitive.b, primitive.c))};
}

std::pair<PrimitiveTree::Node, PrimitiveTree::Node> PrimitiveTree::halves(const Node &node) const {
    const std::size_t middle = node.first + (node.end - node.first) / 2;
    return {{2 * node.box + 1, node.first, middle, node.level + 1}, {2 * node.box + 2, middle, node.end, node.level + 1}};
}

void PrimitiveTree::build(const Node &node) {
    Box box = box_of(geometry_.primitives[numbers_[node.first]]);
    for (std::size_t i = node.first + 1; i < node.end; ++i) {
        const Box other = box_of(geometry_.primitives[numbers_[i]]);
        box.low = glm::min(box.low, other.low), box.high = glm::max(box.high, other.high);
    }
    boxes_[node.box] = box;
    if (node.level == levels_) return;
    const auto [left, right] = halves(node);
    const vec3 size = box.high - box.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto at = [&](std::size_t i) { return numbers_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(node.first), at(left.end), at(node.end), [&](uint a, uint b) {
        const Box box_a = box_of(geometry_.primitives[a]), box_b = box_of(geometry_.primitives[b]);
        return box_a.low[axis] + box_a.high[axis] < box_b.low[axis] + box_b.high[axis];
    });
    if (node.end - node.first < least_in_task) return build(left), build(right);
    tbb::parallel_invoke([this, left = left] { build(left); }, [this, right = right] { build(right); });
}

/// Along the ray, and across it by the axes that separate a line from a box.
bool PrimitiveTree::may_meet(const RayInSpace &ray, const Box &box, double end) {
    const dvec3 half = 0.5 * (dvec3(box.high) - dvec3(box.low)), middle = 0.5 * (dvec3(box.high) + dvec3(box.low)) - ray.origin;
    const dvec3 way = ray.direction / ray.length, sizes = glm::abs(way);
    const double slip = 4 * slip_within(ray, glm::length(middle) + glm::length(half));
    const double depth = glm::dot(middle, way), extent = glm::dot(half, sizes) + slip;
    if (depth + extent < 0 || depth - extent > std::min(end, ray.t_max) * ray.length) return false;
    const dvec3 beside = glm::abs(glm::cross(middle, way));
    return beside.x <= half.y * sizes.z + half.z * sizes.y + slip && beside.y <= half.z * sizes.x + half.x * sizes.z + slip &&
           beside.z <= half.x * sizes.y + half.y * sizes.x + slip;
}

double PrimitiveTree::depth_of(const RayInSpace &ray, const Box &box) { return glm::dot(dvec3(box.low) + dvec3(box.high), ray.direction); }

void PrimitiveTree::find_in_leaf(Search &search, const Node &node) const {
    const std::size_t before = search.crossings.size();
    for (std::size_t i = node.first; i < node.end; ++i)
        add_crossings(search.crossings, search.ray, geometry_.primitives[numbers_[i]], numbers_[i], search.instance);
    for (std::size_t i = before; i < search.crossings.size(); ++i)
        if (search.crossings[i].certain) search.end = std::min(search.end, search.crossings[i].last);
}

void PrimitiveTree::walk(Search &search, const Node &node) const {
    if (!may_meet(search.ray, boxes_[node.box], search.end)) return;
    if (node.level == levels_) return find_in_leaf(search, node);
    const auto [left, right] = halves(node);
    const bool left_first = depth_of(search.ray, boxes_[left.box]) <= depth_of(search.ray, boxes_[right.box]);
    walk(search, left_first ? left : right);
    walk(search, left_first ? right : left);
}

void PrimitiveTree::add_crossings_of(std::vector<Crossing> &crossings, const RayInSpace &ray, uint instance, double &end) const {
    if (numbers_.empty()) return;
    Search search = {crossings, ray, instance, end};
    walk(search, {0, 0, numbers_.size(), 0});
}

}  // namespace brandung
