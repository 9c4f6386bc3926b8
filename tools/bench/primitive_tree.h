/// PrimitiveTree: which primitives of a space a ray may meet, for the judge: as sure as looking at all, and owing nothing to what is judged.
#pragma once
#include <cstdint>
#include <vector>

#include "tools/bench/crossings.h"

namespace brandung {

/// Boxes in halves of equal numbers, by the middles along the longest side. A box is left out only where it is farther from the ray's line, or from
/// both its ends, than any tracer may see its primitives beside their places.
class PrimitiveTree {
public:
    /// Of a geometry that must live as long.
    PrimitiveTree(const SceneGeometry &geometry, const GeometrySpace &space);
    /// Adds all that add_crossings() finds.
    void add_crossings_of(std::vector<Crossing> &crossings, const RayInSpace &ray, uint instance) const;

private:
    struct Box {
        vec3 low, high;
    };

    static Box box_of(const GeometryPrimitive &primitive);
    static bool may_meet(const RayInSpace &ray, const Box &box);
    void build(std::size_t node, uint level, std::size_t first, std::size_t end);
    void walk(std::vector<Crossing> &crossings, const RayInSpace &ray, uint instance, std::size_t node, uint level, std::size_t first,
              std::size_t end) const;

    const SceneGeometry &geometry_;
    std::vector<uint> numbers_;
    uint levels_ = 0;         ///< below the root
    std::vector<Box> boxes_;  ///< a heap: those of the halves of box i are 2 i + 1 and 2 i + 2
};

}  // namespace brandung
