/// Judge: of what tracers say about a ray, what is wrong.
#pragma once
#include <span>
#include <vector>

#include "tools/bench/primitive_tree.h"

namespace brandung {

/// What a tracer says that a ray meets first; where it was asked whether the ray meets anything, that it meets something.
struct Claim {
    bool meets;
    uint primitive = NO_HIT, instance = 0;  ///< only of closest hits
    float t = 0;                            ///< only of closest hits
};

struct Dispute {
    Ray ray;
    bool any;  ///< the question is whether the ray meets anything before its t_max
    Claim ours, theirs;
};

struct DisputeVerdict {
    bool ours_wrong, theirs_wrong;
};

/// In double, by all primitives, which must be triangles and spheres. What a tracer may say is what it may find that sees each vertex a little beside
/// its place, by 2^-21 of the distance from the ray's origin, a vertex always at the same place for a ray: twice what the watertight test of Woop et
/// al. errs by, three roundings in each of two coordinates. (In the space of an instance, to which tracers transform the ray by matrices that are
/// rounded themselves, it is 2^-18 of the magnitudes of all terms.) So a hit may be within that of an edge, and of hits between whose t that does not
/// decide each may be the first. But a ray that passes an edge or a vertex that triangles share, and around which they close, must meet one of them.
class Judge {
public:
    /// Of a geometry that must live as long.
    explicit Judge(const SceneGeometry &geometry);
    std::vector<DisputeVerdict> judge(std::span<const Dispute> disputes) const;

private:
    struct Findings;
    Findings findings(const Ray &ray) const;

    const SceneGeometry &geometry_;
    std::vector<PrimitiveTree> trees_;  ///< by space
};

}  // namespace brandung
