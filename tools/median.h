/// Of times, which other work on the machine makes longer now and then.
#pragma once
#include <algorithm>
#include <vector>

namespace brandung {

/// Of at least one value.
inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

}  // namespace brandung
