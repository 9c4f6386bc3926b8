/// Sums that are the same for any number of threads.
#pragma once
#include <functional>

#include "scene/measures/picture_pair.h"

namespace brandung {

/// The mean of value(i) over the pixels i that are finite: each row is summed on its own, and the rows' sums in their order.
double mean_over_pixels(const PicturePair &pair, const std::function<double(std::size_t)> &value);

}  // namespace brandung
