/// Series: the errors of one way of rendering, over samples and time.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/image.h"
#include "tools/converge/way.h"

namespace brandung {

/// Names of the measures that are followed, as in `brandung compare`.
const std::vector<std::string> &followed_measures();
/// The value of each followed measure of a picture.
using Errors = std::map<std::string, double>;
/// Throws SceneError if the sizes differ.
Errors errors_of(const Picture &picture, const Picture &reference);

/// One picture.
struct Run {
    std::size_t rung;  ///< of the ladder: runs of the same rung are repetitions
    uint seed;
    double samples;  ///< per pixel
    double seconds;  ///< of rendering
    Errors errors;
};

struct Series {
    std::string name;
    std::vector<Run> runs;
    std::optional<Way> way = {};             ///< of those that are rendered here
    std::vector<Departure> departures = {};  ///< from the reference, where it is known how that was rendered, or else from the first series
};

}  // namespace brandung
