/// The list of filters.
#include <cmath>

#include "scene/filters/filter.h"

namespace brandung {
namespace {

double box(double) { return 1; }

double tent(double x) { return 1 - x; }

/// A standard deviation of a third of the radius, moved down so that it ends at 0.
double gaussian(double x) { return std::exp(-4.5 * x * x) - std::exp(-4.5); }

/// With B = C = 1/3 (Mitchell & Netravali, SIGGRAPH 1988, eq. 8).
double mitchell(double x) {
    const double y = 2 * x;
    return y < 1 ? (7 * y - 12) * y * y + 16.0 / 3 : ((-7.0 / 3 * y + 12) * y - 20) * y + 32.0 / 3;
}

/// The window of four terms (Harris, Proc. IEEE 66(1) 1978, table 1: -92 dB).
double blackman_harris(double x) {
    const double angle = M_PI * (x + 1);
    return 0.35875 - 0.48829 * std::cos(angle) + 0.14128 * std::cos(2 * angle) - 0.01168 * std::cos(3 * angle);
}

}  // namespace

const std::vector<FilterKind> &filter_kinds() {
    static const std::vector<FilterKind> kinds = {
        {"box", "box", 0.5f, false, false, box},
        {"tent", "tent", 1, true, false, tent},
        {"gaussian", "tabulated", 1.5f, true, true, gaussian},
        {"mitchell", "tabulated", 2, true, true, mitchell},
        {"blackman_harris", "tabulated", 1.5f, true, true, blackman_harris},
    };
    return kinds;
}

}  // namespace brandung
