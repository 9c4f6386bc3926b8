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
    bool encoded = false;  ///< whether its values were read from the sRGB curve
};

/// How a file's numbers stand for linear light.
enum class Encoding : uint {
    automatic,  ///< floats as linear, integers by the sRGB curve unless the file says that they are linear
    srgb,
    linear,
};

/// Channels beside red, green and blue are left out, transparency too. Of a file with several pictures the first; of one with a data window that
/// window. Throws SceneError.
Picture read_picture(const std::string &file, Encoding encoding = Encoding::automatic);

/// Throws SceneError if OpenImageIO knows no format of the file's extension, if the format cannot take a picture of that size, or if no file could
/// be written there.
void check_picture_writable(const std::string &file, uint width, uint height);
/// Whether the file's format stores metadata of any name.
bool stores_metadata(const std::string &file);
/// Formats of floats (EXR, HDR, TIFF) get radiance as it is, others (PNG, JPEG, PPM, ...) 8 bits through `exposure` [EV, -100 to 100] and the sRGB
/// curve. The file appears under its name only when it is complete. Throws SceneError.
void write_picture(const std::string &file, const Picture &picture, float exposure);

/// The same 8 bits as a PNG file's bytes, compressed quickly rather than well. Throws SceneError.
std::vector<unsigned char> png_bytes(const Picture &picture, float exposure);

}  // namespace brandung
