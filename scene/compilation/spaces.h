/// Spaces: the world, and the groups that instances place in it.
#pragma once
#include <memory>
#include <vector>

#include "scene/scene.h"

namespace brandung {

using Shapes = std::vector<std::unique_ptr<Shape>>;

/// A primitive of the scene: the i-th of a shape.
struct PrimitiveOf {
    const Shape *shape;
    std::size_t i;
};

/// What shares a space: primitives in scene order, numbered from `first` on.
struct Space {
    std::vector<PrimitiveOf> primitives;
    uint first;
    bool is_textured = false;  ///< whether an instance replaces its materials by one with a texture
};

/// Groups that have instances, in order: what others hold is left out.
std::vector<std::size_t> groups_in_use(const Scene &scene);
/// Of one of them.
std::size_t place_in(const std::vector<std::size_t> &used, std::size_t group);

/// The world's, then those of the groups in use.
std::vector<const Shapes *> shapes_in_use(const Scene &scene);
/// The world, then the groups in use, whose primitives least_sizes() has counted.
std::vector<Space> spaces_in_use(const Scene &scene);
/// Of the primitives in them, in the order of primitive_kinds().
std::vector<const PrimitiveKind *> primitive_kinds_in_use(const Scene &scene);

/// Of a material, or one of its members.
bool is_textured(const Scene &scene, uint material);

}  // namespace brandung
