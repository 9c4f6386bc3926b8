/// Pictures on disk, through OpenImageIO.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "kernels/core/portable.h"
#include "scene/window.h"

namespace brandung {

/// A number per pixel beside radiance: floats, or else whole numbers.
struct PictureChannel {
    std::string name;
    std::vector<float> floats;
    std::vector<uint> numbers;
};

/// Linear radiance, row by row from the top.
struct Picture {
    uint width = 0, height = 0;
    std::vector<vec3> pixels;
    std::map<std::string, std::string> metadata;
    uint left = 0, top = 0;                  ///< its place in the whole picture of which it is a window
    uint whole_width = 0, whole_height = 0;  ///< of that; 0 if it is whole itself
    std::vector<PictureChannel> channels = {};
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

/// How a file stores a value.
enum class Bits { eight, sixteen, half, single };
/// In this order: "8", "16", "half", "float".
const std::vector<std::string> &names_of_bits();

/// How pictures are stored.
struct PictureStyle {
    float exposure = 0;           ///< of integers [EV, -100 to 100]
    uint tone = 0;                ///< of integers: its place in tone_kinds()
    std::vector<Bits> bits = {};  ///< each format takes the first that it has, or else its own choice
    uint quality = 98;            ///< of JPEG, 1 to 100
};

/// Throws SceneError if OpenImageIO knows no format of the file's extension, if the format cannot take a picture of that size, or if no file could
/// be written there.
void check_picture_writable(const std::string &file, uint width, uint height, const PictureStyle &style = {});
/// Whether the file's format stores metadata of any name.
bool stores_metadata(const std::string &file);
/// What the file's format can store, its own choice first.
std::vector<Bits> bits_of_format(const std::string &file);
/// Whether the file can have channels beside red, green and blue.
bool stores_channels(const std::string &file);
bool is_jpeg(const std::string &file);
/// Floats are stored as they are, integers through exposure and tone curve. Only EXR has a place in a whole picture, and
/// further channels, which have 32 bits. The file appears under its name
/// only when it is complete. Throws SceneError.
void write_picture(const std::string &file, const Picture &picture, const PictureStyle &style = {});

/// A PNG file's bytes, of 8 bits a value, compressed quickly rather than well. Throws SceneError.
std::vector<unsigned char> png_bytes(const Picture &picture, const PictureStyle &style);

}  // namespace brandung
