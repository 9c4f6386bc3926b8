/// Small pictures by formulas, for measures.
#pragma once
#include <functional>

#include "scene/measures/picture_pair.h"
#include "scene/tone.h"

namespace brandung {

/// The value of a channel.
using Pattern = std::function<float(int x, int y, int c)>;

inline Picture picture_of(uint width, uint height, const Pattern &pattern) {
    Picture picture{width, height, {}, {}};
    for (int y = 0; y < int(height); ++y)
        for (int x = 0; x < int(width); ++x) picture.pixels.push_back(vec3(pattern(x, y, 0), pattern(x, y, 1), pattern(x, y, 2)));
    return picture;
}

/// Linear values.
inline PicturePair hdr_pair(uint width, uint height, const Pattern &test, const Pattern &reference) {
    return pair_pictures(picture_of(width, height, test), picture_of(width, height, reference), DynamicRange::hdr);
}

/// Encoded values from 0 to 255.
inline PicturePair ldr_pair(uint width, uint height, const Pattern &test, const Pattern &reference) {
    const auto decoded = [](const Pattern &bytes) { return [&](int x, int y, int c) { return srgb_decoded(bytes(x, y, c) / 255); }; };
    return pair_pictures(picture_of(width, height, decoded(test)), picture_of(width, height, decoded(reference)), DynamicRange::ldr);
}

inline Pattern constant(const vec3 &value) {
    return [=](int, int, int c) { return value[c]; };
}

// Encoded values from 0 to 255.
inline float ramp(int x, int y, int c) { return float(3 * x + 2 * y + 40 * c); }
inline float grainy_ramp(int x, int y, int c) { return ramp(x, y, c) + float((31 * x + 17 * y + 7 * c) % 23); }
inline float board(int x, int y, int c) { return (x / 4 + y / 4) % 2 == 0 ? float(60 + 40 * c) : float(200 - 30 * c); }
inline float shifted_board(int x, int y, int c) { return board(x + 1, y, c); }

// Linear values.
inline float waves(int x, int y, int c) { return float((5 * x + 3 * y + 11 * c) % 64) / 16; }
inline float grainy_waves(int x, int y, int c) { return waves(x, y, c) + float((31 * x + 17 * y) % 8) / 32; }
inline float waves_with_fireflies(int x, int y, int c) { return x % 8 == 3 && y % 8 == 3 ? 20 : waves(x, y, c); }

}  // namespace brandung
