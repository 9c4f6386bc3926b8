/// LDR-FLIP: the difference that is seen when two pictures are shown in turn (Andersson et al., FLIP: A Difference Evaluator for Alternating Images,
/// HPG 2020). In double precision: the root of feature differences makes 1e-4 of the rounding of floats.
#pragma once
#include "scene/measures/convolution.h"

namespace brandung {

/// Linear light from 0 to 1, row by row from the top.
struct LinearPicture {
    uint width = 0, height = 0;
    std::vector<vec3> pixels;
};

/// The evaluator at one distance from the screen.
class LdrFlip {
public:
    explicit LdrFlip(double pixels_per_degree);

    /// The difference of each pixel, from 0 to 1.
    std::vector<float> operator()(const LinearPicture &test, const LinearPicture &reference) const;

private:
    /// What is seen of a picture, per pixel.
    struct Seen {
        std::vector<glm::dvec3> colours;   ///< L*a*b*, with chroma as Hunt's effect leaves it
        std::vector<glm::dvec2> features;  ///< strength of an edge and of a point
    };

    Seen seen(const LinearPicture &picture) const;
    std::vector<glm::dvec3> colours(const Planes &opponents) const;
    std::vector<glm::dvec2> features(const Planes &opponents) const;

    ChannelWeights contrast_across_, contrast_down_;  ///< contrast sensitivity: achromatic, red-green, blue-yellow in two parts
    ChannelWeights feature_across_, feature_down_;    ///< first and second derivative across, and down
};

}  // namespace brandung
