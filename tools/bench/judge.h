/// Judge: of two tracers that disagree about a ray, who is wrong.
#pragma once
#include <span>
#include <vector>

#include "kernels/core/items.h"
#include "tools/bench/scene_geometry.h"

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

struct Verdict {
    bool ours_wrong, theirs_wrong;
};

/// By every primitive of the scene, in double. What a tracer may say is what the rounding of floats explains: a hit within it of an edge, and one of
/// hits between whose t it cannot tell. Of each sum of products the bound is 2^-20 of the products' magnitudes, some four times what the usual
/// formulas in float err by; in the space of an instance, to which tracers transform the ray by matrices that are rounded themselves, 2^-18.
/// Primitives are triangles and spheres.
std::vector<Verdict> judge(const SceneGeometry &geometry, std::span<const Dispute> disputes);

}  // namespace brandung
