/// Work: the order in which pixels are rendered.
#pragma once
#include <vector>

#include "scene/window.h"

namespace brandung {

/// Goes through a window of a picture in blocks of 8 x 8 pixels, within blocks along a Z curve, so that neighbours in a wave are neighbours in the
/// picture.
class PixelOrder {
public:
    explicit PixelOrder(const Window &window) : window_(window) {}
    /// The next pixels, x in the lower 16 bits and y in the upper: `count` of them, fewer at the end, none after it.
    std::vector<uint> next(std::size_t count);

private:
    Window window_;
    std::uint64_t place_ = 0;  ///< in the window rounded up to whole blocks
};

}  // namespace brandung
