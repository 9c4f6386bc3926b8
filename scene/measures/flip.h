/// FLIP of two pictures, LDR or HDR.
#pragma once
#include "scene/measures/picture_pair.h"

namespace brandung {

/// A screen of 3840 pixels over 0.7 m, seen from 0.7 m: 3840 pi / 180.
inline constexpr double default_pixels_per_degree = 67.02064327658226;
inline constexpr double min_pixels_per_degree = 1, max_pixels_per_degree = 1000;

/// The exposures under which HDR pictures are looked at [EV].
struct Exposures {
    double start = 0, stop = 0;
    uint count = 0;  ///< 0 for LDR pictures
};

struct Flip {
    double mean = 0;         ///< over the finite pixels
    std::vector<float> map;  ///< the difference of each pixel, from 0 to 1
    Exposures exposures;
};

/// LDR-FLIP, or HDR-FLIP (Andersson et al., Visualizing Errors in Rendered High Dynamic Range Images, Eurographics 2021): a pixel's greatest
/// LDR-FLIP under a range of exposures that the reference gives.
Flip flip(const PicturePair &pair, double pixels_per_degree);

}  // namespace brandung
