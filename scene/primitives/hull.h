/// Hulls: a few discs and balls whose convex hull holds a primitive, closer than its box does.
#pragma once
#include <array>

#include "kernels/core/portable.h"
#include "scene/bounds.h"

namespace brandung {

/// A ball, or where `axis` is not 0 a disc across that direction, of unit length.
struct HullPart {
    vec3 center;
    float radius = 0;
    vec3 axis{0};
};

struct Hull {
    std::array<HullPart, 8> parts;
    uint count = 0;

    void add(const HullPart &part) { parts[count++] = part; }
};

inline Hull hull_of_box(const Bounds &box) {
    Hull hull;
    for (uint corner = 0; corner < 8; ++corner)
        hull.add({.center = {(corner & 1 ? box.high : box.low).x, (corner & 2 ? box.high : box.low).y, (corner & 4 ? box.high : box.low).z}});
    return hull;
}

}  // namespace brandung
