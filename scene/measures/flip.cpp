#include "scene/measures/flip.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/measures/colour.h"
#include "scene/measures/ldr_flip.h"
#include "scene/measures/sum.h"

namespace brandung {
namespace {

/// (a0 x^2 + a1 x) / (b0 x^2 + b1 x + b2), the curve of Narkowicz (2015) for ACES, behind his exposure by 0.6.
constexpr double a0 = 0.36 * 2.51, a1 = 0.6 * 0.03, b0 = 0.36 * 2.43, b1 = 0.6 * 0.59, b2 = 0.14;
constexpr double bright = 0.85;  ///< what the curve makes of the brightest light that counts as well exposed

constexpr double darkest = std::numeric_limits<float>::epsilon();  ///< luminance for which an exposure is looked for

double tone(double x) { return std::clamp((a0 * x + a1) * x / ((b0 * x + b1) * x + b2), 0.0, 1.0); }

/// The light of which the curve makes `bright`: the positive root of (a0 - bright b0) x^2 + (a1 - bright b1) x - bright b2.
double bright_light() {
    const double a = a0 - bright * b0, half_b = 0.5 * (a1 - bright * b1), c = -bright * b2;
    return (-half_b + std::sqrt(half_b * half_b - a * c)) / a;
}

/// From the one under which the brightest pixel comes out bright to that under which the median does, about a step apart (section 3 of the paper).
Exposures exposures_for(const PicturePair &pair) {
    std::vector<double> light;
    for (std::size_t i = 0; i < pair.reference.size(); ++i)
        if (pair.finite[i]) light.push_back(luminance(glm::dvec3(linear_light(pair.reference[i], pair.range))));
    const auto median = light.begin() + std::ptrdiff_t(light.size() / 2);
    std::nth_element(light.begin(), median, light.end());
    const auto exposure = [](double luminance) { return std::log2(bright_light() / std::max(luminance, darkest)); };
    const double start = exposure(*std::max_element(light.begin(), light.end())), stop = exposure(*median);
    return {start, stop, std::max(2u, uint(std::ceil(stop - start)))};
}

LinearPicture linear_picture(const PicturePair &pair, const std::vector<vec3> &values) {
    LinearPicture picture{pair.width, pair.height, values};
    for (vec3 &pixel : picture.pixels) pixel = linear_light(pixel, pair.range);
    return picture;
}

LinearPicture exposed(LinearPicture picture, double exposure) {
    const double scale = std::exp2(exposure);
    tbb::parallel_for(std::size_t(0), picture.pixels.size(), [&](std::size_t i) {
        vec3 &pixel = picture.pixels[i];
        for (int c = 0; c < 3; ++c) pixel[c] = float(tone(scale * pixel[c]));
    });
    return picture;
}

/// The greatest differences under all exposures.
std::vector<float> hdr_flip(const LdrFlip &evaluator, const Exposures &exposures, const LinearPicture &test, const LinearPicture &reference) {
    std::vector<float> greatest(test.pixels.size(), 0.0f);
    const double step = (exposures.stop - exposures.start) / (exposures.count - 1);
    for (uint i = 0; i < exposures.count; ++i) {
        const double exposure = exposures.start + i * step;
        const std::vector<float> map = evaluator(exposed(test, exposure), exposed(reference, exposure));
        std::transform(map.begin(), map.end(), greatest.begin(), greatest.begin(), [](float a, float b) { return std::max(a, b); });
    }
    return greatest;
}

}  // namespace

Flip flip(const PicturePair &pair, double pixels_per_degree) {
    const LdrFlip evaluator(pixels_per_degree);
    const LinearPicture test = linear_picture(pair, pair.test), reference = linear_picture(pair, pair.reference);
    Flip flip;
    if (pair.range == DynamicRange::hdr) {
        flip.exposures = exposures_for(pair);
        flip.map = hdr_flip(evaluator, flip.exposures, test, reference);
    } else {
        flip.map = evaluator(test, reference);
    }
    flip.mean = mean_over_pixels(pair, [&](std::size_t i) { return flip.map[i]; });
    return flip;
}

}  // namespace brandung
