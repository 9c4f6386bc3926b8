/// SSIM: how alike the structures of two pictures are (Wang et al., Image Quality Assessment: From Error Visibility to Structural Similarity, 2004).
#pragma once
#include <optional>

#include "scene/measures/picture_pair.h"

namespace brandung {

inline constexpr uint ssim_window = 11;  ///< edge of its Gaussian window [pixels]

/// Mean over the windows that lie in the picture and have a finite centre, of luma (0.2126 R + 0.7152 G + 0.0722 B) of the pixels as they are shown:
/// sRGB-encoded, HDR pictures at exposure 0. 1 for equal pictures; nothing where the picture has no such window.
std::optional<double> ssim(const PicturePair &pair);

}  // namespace brandung
