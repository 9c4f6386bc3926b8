#include "scene/measures/sum.h"

#include <tbb/parallel_for.h>

#include <numeric>

namespace brandung {

double mean_over_pixels(const PicturePair &pair, const std::function<double(std::size_t)> &value) {
    std::vector<double> rows(pair.height, 0.0);
    tbb::parallel_for(uint(0), pair.height, [&](uint y) {
        for (std::size_t i = std::size_t(y) * pair.width; i < std::size_t(y + 1) * pair.width; ++i)
            if (pair.finite[i]) rows[y] += value(i);
    });
    return std::accumulate(rows.begin(), rows.end(), 0.0) / double(pair.finite.size() - pair.not_finite());
}

}  // namespace brandung
