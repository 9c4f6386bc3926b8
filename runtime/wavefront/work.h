/// Work: the order in which pixels are rendered.
#pragma once
#include <vector>

#include "kernels/core/portable.h"

namespace brandung {

/// Goes through a picture in blocks of 8 x 8 pixels, within blocks along a Z curve, so that neighbours in a wave are neighbours in the picture.
class PixelOrder {
public:
    PixelOrder(uint width, uint height) : width_(width), height_(height) {}
    /// The next pixels, x in the lower 16 bits and y in the upper: `count` of them, fewer at the end, none after it.
    std::vector<uint> next(std::size_t count);

private:
    uint width_, height_;
    std::uint64_t place_ = 0;  ///< in the picture rounded up to whole blocks
};

}  // namespace brandung
