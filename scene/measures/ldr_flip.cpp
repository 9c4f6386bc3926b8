#include "scene/measures/ldr_flip.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/measures/colour.h"

namespace brandung {
namespace {

using glm::dvec2, glm::dvec3, glm::dvec4;

constexpr double pi = std::numbers::pi;

/// A Gaussian of the contrast sensitivity functions in space: a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees (table 1 of the paper).
struct Sensitivity {
    double a, b;
};
constexpr Sensitivity achromatic{1, 0.0047}, red_green{1, 0.0053}, blue_yellow[2] = {{34.1, 0.04}, {13.5, 0.025}};

constexpr double feature_width = 0.082;  ///< of an edge as it is detected, two standard deviations [degrees]
constexpr double feature_exponent = 0.5;
constexpr double colour_exponent = 0.7;
constexpr double compressed_from = 0.4, compressed_to = 0.95;  ///< colour differences up to so much of the greatest take so much of the range

/// Standard deviation of the Gaussian [degrees].
double deviation(const Sensitivity &s) { return std::sqrt(s.b / (2 * pi * pi)); }

double sum(const Weights &weights) {
    double all = 0;
    for (const double weight : weights) all += weight;
    return all;
}

Weights scaled(Weights weights, double factor) {
    for (double &weight : weights) weight *= factor;
    return weights;
}

/// Positive weights are scaled to a sum of 1, negative ones to -1.
Weights balanced(Weights weights) {
    double positive = 0, negative = 0;
    for (const double weight : weights) (weight > 0 ? positive : negative) += weight;
    for (double &weight : weights) weight /= weight > 0 ? positive : -negative;
    return weights;
}

/// The Gaussian's first derivative, up to its sign.
Weights first_derivative(Weights weights) {
    const double radius = double(weights.size() / 2);
    for (std::size_t k = 0; k < weights.size(); ++k) weights[k] *= double(k) - radius;
    return balanced(weights);
}

/// Its second derivative.
Weights second_derivative(Weights weights, double sigma) {
    const double radius = double(weights.size() / 2);
    for (std::size_t k = 0; k < weights.size(); ++k) weights[k] *= std::pow((double(k) - radius) / sigma, 2) - 1;
    return balanced(weights);
}

/// Of linear light. Colours lose chroma where they are dark (Hunt 1952).
dvec3 perceived_colour(const dvec3 &linear) {
    const dvec3 c = lab(linear);
    return dvec3(c.x, 0.01 * c.x * c.y, 0.01 * c.x * c.z);
}

/// HyAB (Abasi et al. 2020): distances in lightness and in chroma are added.
double colour_distance(const dvec3 &a, const dvec3 &b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

/// Between 0 and 1, with more room for small differences (section 4.1.3 of the paper). The greatest distance is that of green and blue.
double colour_difference(const dvec3 &a, const dvec3 &b) {
    static const double greatest = std::pow(colour_distance(perceived_colour(dvec3(0, 1, 0)), perceived_colour(dvec3(0, 0, 1))), colour_exponent);
    const double difference = std::pow(colour_distance(a, b), colour_exponent), knee = compressed_from * greatest;
    if (difference < knee) return difference / knee * compressed_to;
    return compressed_to + (difference - knee) / (greatest - knee) * (1 - compressed_to);
}

double feature_difference(const dvec2 &a, const dvec2 &b) {
    const double greater = std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
    return std::pow(greater / std::numbers::sqrt2, feature_exponent);
}

Planes opponent_planes(const LinearPicture &picture) {
    Planes planes{picture.width, picture.height, std::vector<dvec4>(picture.pixels.size())};
    tbb::parallel_for(std::size_t(0), picture.pixels.size(), [&](std::size_t i) {
        const dvec3 c = opponent(dvec3(picture.pixels[i]));
        planes.pixels[i] = dvec4(c.x, c.y, c.z, c.z);
    });
    return planes;
}

}  // namespace

LdrFlip::LdrFlip(double pixels_per_degree) {
    const int radius = int(std::ceil(3 * deviation(blue_yellow[0]) * pixels_per_degree));  // of the widest
    const auto of = [&](const Sensitivity &s) { return gaussian(radius, deviation(s) * pixels_per_degree); };
    const Weights wide = of(blue_yellow[0]), narrow = of(blue_yellow[1]);
    const auto amplitude = [](const Sensitivity &s) { return s.a * std::sqrt(pi / s.b); };
    const double total = amplitude(blue_yellow[0]) * sum(wide) * sum(wide) + amplitude(blue_yellow[1]) * sum(narrow) * sum(narrow);
    contrast_across_ = {normalized(of(achromatic)), normalized(of(red_green)), wide, narrow};
    contrast_down_ = {contrast_across_[0], contrast_across_[1], scaled(wide, amplitude(blue_yellow[0]) / total),
                      scaled(narrow, amplitude(blue_yellow[1]) / total)};

    const double sigma = 0.5 * feature_width * pixels_per_degree;
    const Weights blur = gaussian(int(std::ceil(3 * sigma)), sigma);
    const Weights edge = first_derivative(blur), point = second_derivative(blur, sigma), smooth = normalized(blur);
    feature_across_ = {edge, point, smooth, smooth};
    feature_down_ = {smooth, smooth, edge, point};
}

std::vector<dvec3> LdrFlip::colours(const Planes &opponents) const {
    const Planes blurred = filtered(opponents, contrast_across_, contrast_down_);
    std::vector<dvec3> colours(blurred.pixels.size());
    tbb::parallel_for(std::size_t(0), colours.size(), [&](std::size_t i) {
        const dvec4 &c = blurred.pixels[i];
        colours[i] = perceived_colour(glm::clamp(from_opponent(dvec3(c.x, c.y, c.z + c.w)), dvec3(0), dvec3(1)));
    });
    return colours;
}

std::vector<dvec2> LdrFlip::features(const Planes &opponents) const {
    Planes lightness = opponents;
    for (dvec4 &pixel : lightness.pixels) pixel = dvec4((pixel.x + 16) / 116);
    const Planes derivatives = filtered(lightness, feature_across_, feature_down_);
    std::vector<dvec2> features(derivatives.pixels.size());
    for (std::size_t i = 0; i < features.size(); ++i) {
        const dvec4 &d = derivatives.pixels[i];
        features[i] = dvec2(std::hypot(d.x, d.z), std::hypot(d.y, d.w));
    }
    return features;
}

LdrFlip::Seen LdrFlip::seen(const LinearPicture &picture) const {
    const Planes opponents = opponent_planes(picture);
    return {colours(opponents), features(opponents)};
}

std::vector<float> LdrFlip::operator()(const LinearPicture &test, const LinearPicture &reference) const {
    const Seen a = seen(test), b = seen(reference);
    std::vector<float> difference(a.colours.size());
    tbb::parallel_for(std::size_t(0), difference.size(), [&](std::size_t i) {
        const double feature = feature_difference(a.features[i], b.features[i]);
        difference[i] = float(std::pow(colour_difference(a.colours[i], b.colours[i]), 1 - feature));
    });
    return difference;
}

}  // namespace brandung
