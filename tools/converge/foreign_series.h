/// Series of pictures that another renderer has made.
#pragma once
#include "tools/converge/series.h"

namespace brandung {

/// `folder` has the pictures and `times.json`: [{"file": "a.exr", "seconds": 1.5, "samples": 16, "rung": 0, "seed": 0}, ...]. Without "rung" pictures
/// of as many samples, or else of the same time, are repetitions; "samples" and "seed" may be left out. Throws SceneError, with the place.
Series read_foreign_series(const std::string &name, const std::string &folder, const Picture &reference);

}  // namespace brandung
