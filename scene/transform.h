/// Affine maps: how groups are placed in the world.
#pragma once
#include <optional>

#include "kernels/primitives/instance.h"
#include "scene/bounds.h"

namespace brandung {

class Parameters;

/// p -> linear p + offset.
struct AffineMap {
    glm::dmat3 linear{1};
    glm::dvec3 offset{0};
    bool operator==(const AffineMap &) const = default;
};
/// First `first`, then `second`.
AffineMap then(const AffineMap &first, const AffineMap &second);

AffineMap translation(glm::dvec3 by);
AffineMap scaling(glm::dvec3 by);
/// Counterclockwise as seen from where `axis` points to, which has any length but 0. Multiples of 90 degrees are exact about the coordinate axes.
AffineMap rotation(double degrees, glm::dvec3 axis);

/// The map "transform" of an instance: a list of steps, or one; the identity if absent. Throws SceneError.
AffineMap read_transform(const Parameters &parameters);

/// A map as kernels have it, and its inverse.
struct TransformPair {
    Transform to_world, to_group;
};
/// Nothing if the map, rounded to floats, is singular, or where it or its inverse has numbers beyond max_magnitude.
std::optional<TransformPair> make_transforms(const AffineMap &map);

/// A box around all that rays can meet of a group with these bounds: larger than the group by more than the rounding of the transforms.
Bounds bounds_in_world(const TransformPair &transforms, const Bounds &bounds);

}  // namespace brandung
