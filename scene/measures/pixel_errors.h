/// Errors that ask each pixel on its own.
#pragma once
#include "scene/measures/picture_pair.h"

namespace brandung {

inline constexpr uint error_block_size = 16;  ///< edge of the blocks of which the worst is found [pixels]

/// A square of pixels, cut off at the right and lower edge of the picture.
struct ErrorBlock {
    uint x = 0, y = 0, width = 0, height = 0;  ///< of its upper left corner, and its size [pixels]
    double relmse = 0;                         ///< of its pixels
};

/// The greatest absolute difference of a channel.
struct MaxError {
    uint x = 0, y = 0, channel = 0;
    double error = 0;
};

/// Means are over all channels of the finite pixels; a is the picture under test, b the reference.
struct PixelErrors {
    double mse = 0;          ///< mean of (a - b)^2
    double relmse = 0;       ///< mean of (a - b)^2 / (b^2 + 0.01)
    double mape = 0;         ///< mean of |a - b| / (|b| + 0.01)
    double peak = 1;         ///< for PSNR: 1 for LDR; for HDR the greatest value of both pictures, at least 1
    double psnr = 0;         ///< 10 log10(peak^2 / mse) [dB]; infinite for equal pictures
    MaxError max_error;      ///< the first of equals in order of rows
    ErrorBlock worst_block;  ///< that of the greatest relMSE, the first of equals in order of rows
    glm::dvec3 test_mean{0}, reference_mean{0};
};

PixelErrors pixel_errors(const PicturePair &pair);

}  // namespace brandung
