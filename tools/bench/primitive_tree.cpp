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
    if (!numbers_.empty()) build(0, 0, 0, numbers_.size());
}

PrimitiveTree::Box PrimitiveTree::box_of(const GeometryPrimitive &primitive) {
    if (primitive.kind == GeometryPrimitive::Kind::sphere) {
        // Their sums are rounded by less than what boxes are grown by.
        const vec3 radius(std::abs(primitive.b.x));
        return {primitive.a - radius, primitive.a + radius};
    }
    return {glm::min(primitive.a, glm::min(primitive.b, primitive.c)), glm::max(primitive.a, glm::max(primitive.b, primitive.c))};
}

void PrimitiveTree::build(std::size_t node, uint level, std::size_t first, std::size_t end) {
    Box box = box_of(geometry_.primitives[numbers_[first]]);
    for (std::size_t i = first + 1; i < end; ++i) {
        const Box other = box_of(geometry_.primitives[numbers_[i]]);
        box.low = glm::min(box.low, other.low), box.high = glm::max(box.high, other.high);
    }
    boxes_[node] = box;
    if (level == levels_) return;
    const vec3 size = box.high - box.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t middle = first + (end - first) / 2;
    const auto at = [&](std::size_t i) { return numbers_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(end), [&](uint a, uint b) {
        const Box box_a = box_of(geometry_.primitives[a]), box_b = box_of(geometry_.primitives[b]);
        return box_a.low[axis] + box_a.high[axis] < box_b.low[axis] + box_b.high[axis];
    });
    const auto left = [&] { build(2 * node + 1, level + 1, first, middle); };
    const auto right = [&] { build(2 * node + 2, level + 1, middle, end); };
    end - first < least_in_task ? (left(), right()) : tbb::parallel_invoke(left, right);
}

/// Along the ray, and across it by the axes that separate a line from a box.
bool PrimitiveTree::may_meet(const RayInSpace &ray, const Box &box) {
    const dvec3 half = 0.5 * (dvec3(box.high) - dvec3(box.low)), middle = 0.5 * (dvec3(box.high) + dvec3(box.low)) - ray.origin;
    const dvec3 way = ray.direction / ray.length, sizes = glm::abs(way);
    const double slip = 4 * slip_within(ray, glm::length(middle) + glm::length(half));
    const double depth = glm::dot(middle, way), extent = glm::dot(half, sizes) + slip;
    if (depth + extent < 0 || depth - extent > ray.t_max * ray.length) return false;
    const dvec3 beside = glm::abs(glm::cross(middle, way));
    return beside.x <= half.y * sizes.z + half.z * sizes.y + slip && beside.y <= half.z * sizes.x + half.x * sizes.z + slip &&
           beside.z <= half.x * sizes.y + half.y * sizes.x + slip;
}

void PrimitiveTree::walk(std::vector<Crossing> &crossings, const RayInSpace &ray, uint instance, std::size_t node, uint level, std::size_t first,
                         std::size_t end) const {
    if (!may_meet(ray, boxes_[node])) return;
    if (level == levels_) {
        for (std::size_t i = first; i < end; ++i) add_crossings(crossings, ray, geometry_.primitives[numbers_[i]], numbers_[i], instance);
        return;
    }
    const std::size_t middle = first + (end - first) / 2;
    walk(crossings, ray, instance, 2 * node + 1, level + 1, first, middle);
    walk(crossings, ray, instance, 2 * node + 2, level + 1, middle, end);
}

void PrimitiveTree::add_crossings_of(std::vector<Crossing> &crossings, const RayInSpace &ray, uint instance) const {
    if (!numbers_.empty()) walk(crossings, ray, instance, 0, 0, 0, numbers_.size());
}

}  // namespace brandung
