/// Reconstruction filters: how much a sample counts in its pixel, by where it lies.
#pragma once
#include <vector>

#include "kernels/filters/filter.h"
#include "scene/scene.h"

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

constexpr float min_splat_radius = 0.5;  ///< [pixels]: of any less there are places in a pixel from which samples count nowhere
constexpr float max_splat_radius = 4;    ///< [pixels]
/// Whether samples of such a film lie evenly in their pixels and count in all that the filter reaches, instead of being drawn from the filter.
bool splats(const FilmSettings &film);
/// How many pixels further, in either direction, a sample counts.
int splat_reach(const FilmSettings &film);
/// The pixels whose samples count in the film's window: as far as the picture has them.
Window sampled_window(const FilmSettings &film);
/// f / f(0) from the centre to the radius, FILTER_INTERVALS + 1 values.
std::vector<float> filter_values(const FilterKind &kind);
/// By how many times the degrees of freedom of a picture's error are fewer because pixels share samples: the sum of the squares of one pixel's
/// correlations with all, itself among them; 1 where each sample counts in one pixel.
double correlated_pixels(const FilmSettings &film);

}  // namespace brandung
