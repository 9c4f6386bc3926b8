/// All measures of a pair of pictures, and the list of their names.
#pragma once
#include <optional>
#include <vector>

#include "scene/measures/flip.h"
#include "scene/measures/pixel_errors.h"

namespace brandung {

/// Everything that is measured.
struct Comparison {
    PixelErrors pixels;
    std::optional<double> ssim;  ///< nothing for pictures smaller than its window
    Flip flip;
    std::size_t not_finite = 0;  ///< pixels left out
};

Comparison compare(const PicturePair &pair, double pixels_per_degree);

/// One number of a comparison.
struct Measure {
    const char *name;     ///< a promise to programs
    const char *meaning;  ///< a few words; a is the picture under test, b the reference
    bool of_likeness;     ///< whether greater is better
    std::optional<double> (*value)(const Comparison &);
};

/// THE list.
const std::vector<Measure> &measures();

}  // namespace brandung
