#include "scene/measures/heat_colour.h"

#include <algorithm>
#include <iterator>

#include "scene/tone.h"

namespace brandung {
namespace {

/// sRGB-encoded, at equal steps from 0 to 1: nine colours of "magma" (van der Walt & Smith 2015).
constexpr float stops[][3] = {{0, 0, 0.014f},           {0.113f, 0.065f, 0.277f}, {0.317f, 0.072f, 0.485f},
                              {0.513f, 0.148f, 0.508f}, {0.716f, 0.215f, 0.475f}, {0.904f, 0.32f, 0.388f},
                              {0.987f, 0.536f, 0.382f}, {0.997f, 0.77f, 0.535f},  {0.987f, 0.991f, 0.75f}};
constexpr int steps = std::size(stops) - 1;

}  // namespace

vec3 heat_colour(float value) {
    const float place = std::clamp(value, 0.0f, 1.0f) * steps;
    const int step = std::min(int(place), steps - 1);
    vec3 colour;
    for (int c = 0; c < 3; ++c) colour[c] = srgb_decoded(stops[step][c] + (place - float(step)) * (stops[step + 1][c] - stops[step][c]));
    return colour;
}

}  // namespace brandung
