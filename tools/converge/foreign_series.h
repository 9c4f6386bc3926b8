/// Series of pictures that another renderer has made.
#pragma once
#include "tools/converge/series.h"

namespace brandung {

/// What its times.json says, with runs whose errors are not measured yet, and the picture of each.
struct ForeignSeries {
    Series series;
    std::vector<std::string> pictures;
};

/// `folder` has the pictures and `times.json`: [{"file": "a.exr", "seconds": 1.5, "samples": 16, "rung": 0, "seed": 0}, ...]. Without "rung" pictures
/// of as many samples, or else of the same time, are repetitions; "samples" and "seed" may be left out. Rungs are in the order of these numbers,
/// whatever the file's is. Reads every picture. Throws SceneError, with the place, also if one has not width x height pixels.
ForeignSeries read_foreign_series(const std::string &name, const std::string &folder, uint width, uint height);
/// The same with the errors from a reference of that size. Throws SceneError.
Series measured(ForeignSeries foreign, const Picture &reference);

}  // namespace brandung
