#include "scene/measures/ssim.h"

#include "scene/measures/convolution.h"

namespace brandung {
namespace {

using glm::dvec4;

constexpr int radius = int(ssim_window) / 2;
constexpr double sigma = 1.5;                         ///< of the window [pixels]
constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;  ///< (K L)^2 with the paper's K and values up to L = 1

double luma(const vec3 &shown) { return glm::dot(glm::dvec3(shown), glm::dvec3(0.2126, 0.7152, 0.0722)); }

/// Local means of a, b, a^2 + b^2 and a b.
Planes moments(const PicturePair &pair) {
    Planes planes{pair.width, pair.height, {}};
    for (std::size_t i = 0; i < pair.test.size(); ++i) {
        const double a = luma(as_shown(pair.test[i], pair.range)), b = luma(as_shown(pair.reference[i], pair.range));
        planes.pixels.push_back(dvec4(a, b, a * a + b * b, a * b));
    }
    const Weights window = normalized(gaussian(radius, sigma));
    const ChannelWeights windows = {window, window, window, window};
    return filtered(planes, windows, windows);
}

/// Equation 13 of the paper.
double similarity(const dvec4 &moments) {
    const double a = moments.x, b = moments.y, variances = moments.z - a * a - b * b, covariance = moments.w - a * b;
    return (2 * a * b + c1) * (2 * covariance + c2) / ((a * a + b * b + c1) * (variances + c2));
}

}  // namespace

std::optional<double> ssim(const PicturePair &pair) {
    if (pair.width < ssim_window || pair.height < ssim_window) return {};
    const Planes means = moments(pair);
    double sum = 0;
    std::size_t windows = 0;
    for (uint y = radius; y < pair.height - radius; ++y)
        for (uint x = radius; x < pair.width - radius; ++x) {
            const std::size_t i = std::size_t(y) * pair.width + x;
            if (!pair.finite[i]) continue;
            sum += similarity(means.pixels[i]);
            ++windows;
        }
    if (windows == 0) return {};
    return sum / double(windows);
}

}  // namespace brandung
