/// Pictures on disk, through OpenImageIO.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "kernels/core/portable.h"

namespace brandung {

/// Linear radiance, row by row from the top.
struct Picture {
    uint width = 0, height = 0;
    std::vector<vec3> pixels;
    std::map<std::string, std::string> metadata;
};

/// Throws SceneError if OpenImageIO knows no format of the file's extension, or the file could not be written there.
void check_picture_writable(const std::string &file);
/// Formats of floats (EXR, HDR, TIFF, PFM) get radiance as it is, others 8 bits through `exposure` [EV] and the sRGB curve.
/// The file appears under its name only when it is complete. Throws SceneError.
void write_picture(const std::string &file, const Picture &picture, float exposure);

}  // namespace brandung
