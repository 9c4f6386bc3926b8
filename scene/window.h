/// A part of a picture.
#pragma once
#include "kernels/core/portable.h"

namespace brandung {

/// Pixels from the left and from the top; right and bottom are exclusive.
struct Window {
    uint left = 0, top = 0, right = 0, bottom = 0;

    uint width() const { return right - left; }
    uint height() const { return bottom - top; }
    uint64 pixels() const { return uint64{width()} * height(); }
    bool operator==(const Window &) const = default;
};

}  // namespace brandung
