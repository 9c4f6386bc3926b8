/// Where a ray may cross a primitive, and whether rounding explains what a kernel says of it.
#pragma once
#include <string>
#include <vector>

#include "runtime/selftest/extended.h"

namespace brandung {

/// t to within `error`, by which rounding may move it; `sure` means that no rounding can make the kernel overlook it. Whether it lies before or
/// behind the ray's beginning is decided with more care by some kinds: only a |t| of up to `side_error` may be mistaken.
struct Root {
    extended t, error;
    bool sure;
    extended side_error = error;
};

/// What a kernel says of the closest one.
struct Crossed {
    bool hit;
    float t;
};

struct Verdict {
    std::string fault;       ///< empty where all roots explain it
    extended nearest{};      ///< the root that is met
    extended allowed{};      ///< its error's bound
    bool ambiguous = false;  ///< rounding may decide whether, or what, is met first
};

/// Nothing sure in (0, t_max] is overlooked, and nothing is made up: t lies within its bound, or within 8 ulp, of a root that is not surely behind.
Verdict judge(const std::vector<Root> &roots, Crossed crossed, float t_max);

/// Whether there is a root in (0, t_max] that no rounding can make a kernel overlook.
bool has_sure_root(const std::vector<Root> &roots, float t_max);

}  // namespace brandung
