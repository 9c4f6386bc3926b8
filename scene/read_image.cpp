/// Reading pictures.
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "scene/error.h"
#include "scene/image.h"
#include "scene/input.h"
#include "scene/tone.h"

namespace brandung {
namespace {

constexpr std::uint64_t max_pixels = 1u << 28;  ///< 3 GiB as linear floats

SceneError cannot_read(const std::string &file, std::string why) {
    std::replace(why.begin(), why.end(), '\n', ' ');
    return SceneError(file + ": cannot read the picture" + (why.empty() ? "" : ": " + why));
}

std::unique_ptr<OIIO::ImageInput> open(const std::string &file) {
    check_readable(file);
    OIIO::ImageSpec as_stored;
    as_stored.attribute("oiio:UnassociatedAlpha", 1);
    auto input = OIIO::ImageInput::open(file, &as_stored);
    if (!input) throw cannot_read(file, OIIO::geterror());
    if (input->format_name() == std::string("null")) throw cannot_read(file, "unknown format");  // one that invents a picture for the name
    if (input->spec().deep) throw cannot_read(file, "its pixels are lists of depths");
    if (input->spec().depth > 1) throw cannot_read(file, "it is a volume");
    return input;
}

/// Where red, green and blue are among the channels: those of these names, else the first three; one or two channels are grey, and grey with alpha.
std::array<std::size_t, 3> colour_channels(const OIIO::ImageSpec &spec) {
    const int red = spec.channelindex("R"), green = spec.channelindex("G"), blue = spec.channelindex("B");
    if (red >= 0 && green >= 0 && blue >= 0) return {std::size_t(red), std::size_t(green), std::size_t(blue)};
    return spec.nchannels < 3 ? std::array<std::size_t, 3>{0, 0, 0} : std::array<std::size_t, 3>{0, 1, 2};
}

bool is_linear(const OIIO::ImageSpec &spec) {
    return spec.format.is_floating_point() || OIIO::Strutil::iequals(spec.get_string_attribute("oiio:ColorSpace"), "linear");
}

/// What the stored values of integers up to `largest` are in linear light.
template <uint largest> const std::vector<float> &linear_values() {
    static const std::vector<float> values = [] {
        std::vector<float> values(largest + 1);
        for (uint i = 0; i <= largest; ++i) values[i] = srgb_decoded(float(double(i) / largest));
        return values;
    }();
    return values;
}

/// Takes a file's values from the sRGB curve; integers of 8 and 16 bits, by far the most, by a table.
void decode(const OIIO::ImageSpec &spec, std::vector<vec3> &pixels) {
    const bool bytes = spec.format == OIIO::TypeDesc::UINT8;
    if (!bytes && spec.format != OIIO::TypeDesc::UINT16) {
        for (vec3 &pixel : pixels) pixel = {srgb_decoded(pixel.x), srgb_decoded(pixel.y), srgb_decoded(pixel.z)};
        return;
    }
    const std::vector<float> &linear = bytes ? linear_values<0xff>() : linear_values<0xffff>();
    const float largest = float(linear.size() - 1);
    for (vec3 &pixel : pixels)
        for (int c = 0; c < 3; ++c) pixel[c] = linear[std::size_t(pixel[c] * largest + 0.5f)];
}

std::map<std::string, std::string> texts(const OIIO::ImageSpec &spec) {
    std::map<std::string, std::string> texts;
    for (const OIIO::ParamValue &attribute : spec.extra_attribs)
        if (attribute.type() == OIIO::TypeDesc::STRING) texts[attribute.name().string()] = attribute.get_string();
    return texts;
}

}  // namespace

Picture read_picture(const std::string &file, Encoding encoding) {
    const auto input = open(file);
    const OIIO::ImageSpec &spec = input->spec();
    const std::size_t channels = std::size_t(spec.nchannels), pixels = std::size_t(spec.width) * std::size_t(spec.height);
    if (pixels > max_pixels) throw cannot_read(file, fmt::format("{} x {} pixels are more than {}", spec.width, spec.height, max_pixels));
    std::vector<float> values(channels * pixels);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data())) throw cannot_read(file, input->geterror());

    const bool linear = encoding == Encoding::linear || (encoding == Encoding::automatic && is_linear(spec));
    Picture picture{uint(spec.width), uint(spec.height), std::vector<vec3>(pixels), texts(spec)};
    picture.encoded = !linear;
    if (spec.full_width != spec.width || spec.full_height != spec.height) {
        picture.left = uint(spec.x - spec.full_x), picture.top = uint(spec.y - spec.full_y);
        picture.whole_width = uint(spec.full_width), picture.whole_height = uint(spec.full_height);
    }
    const std::array<std::size_t, 3> colour = colour_channels(spec);
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t c = 0; c < 3; ++c) picture.pixels[i][int(c)] = values[i * channels + colour[c]];
    if (picture.encoded) decode(spec, picture.pixels);
    return picture;
}

}  // namespace brandung
