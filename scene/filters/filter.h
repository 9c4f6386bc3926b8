/// Reconstruction filters: how much a sample counts in its pixel, by where it lies.
#pragma once
#include <vector>

#include "kernels/filters/filter.h"

namespace brandung {

/// A filter is f(x) f(y), symmetric, and negative, if anywhere, from some distance on outwards.
struct FilterKind {
    const char *name;
    const char *file;  ///< `kernels/filters/<file>.cl` draws places from it
    float radius;      ///< beyond which it is 0, if the scene says no other [pixels]
    bool has_radius;   ///< whether a scene may say another
    bool tabulated;    ///< whether that is by a table
    /// f at a distance from the centre, which is from 0 to 1, the radius being 1; in any unit.
    double (*value)(double x);
};
const std::vector<FilterKind> &filter_kinds();

FilterParams filter_params(const FilterKind &kind, float radius);
/// The table that the kernels read: empty for filters that have none.
std::vector<float> filter_table(const FilterKind &kind, float radius);

}  // namespace brandung
