/// PrimitiveTree: which primitives of a space a ray may meet, for the judge: as sure as looking at all, and owing nothing to what is judged.
#pragma once
#include <utility>
#include <vector>

#include "tools/bench/crossings.h"

namespace brandung {

/// Boxes in halves of equal numbers, by the middles along the longest side. A box is left out only where it is farther from the ray's line, or from
/// both its ends, than any tracer may see its primitives beside their places.
class PrimitiveTree {
public:
    /// Of a geometry that must live as long.
    PrimitiveTree(const SceneGeometry &geometry, const GeometrySpace &space);
    /// Adds what add_crossings() finds that may be met at `end` [t] or before; no tracer passes that, and certain crossings draw it nearer.
    void add_crossings_of(std::vector<Crossing> &crossings, const RayInSpace &ray, uint instance, double &end) const;

private:
    struct Box {
        vec3 low, high;
    };

    static Box box_of(const GeometryPrimitive &primitive);
    struct Node {
        std::size_t box, first, end;  ///< of its primitives, in numbers_
        uint level;
    };
    struct Search {
        std::vector<Crossing> &crossings;
        const RayInSpace &ray;
        uint instance;
        double &end;
    };

    static bool may_meet(const RayInSpace &ray, const Box &box, double end);
    static double depth_of(const RayInSpace &ray, const Box &box);
    std::pair<Node, Node> halves(const Node &node) const;
    void build(const Node &node);
    void find_in_leaf(Search &search, const Node &node) const;
    void walk(Search &search, const Node &node) const;

    const SceneGeometry &geometry_;
    std::vector<uint> numbers_;
    uint levels_ = 0;         ///< below the root
    std::vector<Box> boxes_;  ///< a heap: those of the halves of box i are 2 i + 1 and 2 i + 2
};

}  // namespace brandung
