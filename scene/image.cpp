#include "scene/image.h"

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <filesystem>

#include "scene/error.h"
#include "scene/output.h"

namespace brandung {
namespace {

namespace fs = std::filesystem;

/// IEC 61966-2-1.
float srgb(float linear) { return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f; }

std::vector<std::uint8_t> eight_bits(const std::vector<vec3> &pixels, float exposure) {
    const float scale = std::exp2(exposure);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * pixels.size());
    for (const vec3 &pixel : pixels)
        for (int c = 0; c < 3; ++c) bytes.push_back(static_cast<std::uint8_t>(255 * srgb(glm::clamp(pixel[c] * scale, 0.0f, 1.0f)) + 0.5f));
    return bytes;
}

std::string extension_of(const std::string &file) { return fs::path(file).extension().string(); }

std::unique_ptr<OIIO::ImageOutput> output_for(const std::string &file) {
    auto output = OIIO::ImageOutput::create(file);
    if (!output) {
        OIIO::geterror();
        throw SceneError(file + ": cannot write pictures of type '" + extension_of(file) + "', try .exr or .png");
    }
    return output;
}

bool takes_floats(const OIIO::ImageOutput &output) {
    const std::string format = output.format_name();
    return format == "openexr" || format == "hdr" || format == "tiff" || format == "pnm";
}

void write_pixels(OIIO::ImageOutput &output, const std::string &temporary, const std::string &file, const Picture &picture, float exposure) {
    const bool floats = takes_floats(output);
    OIIO::ImageSpec spec(static_cast<int>(picture.width), static_cast<int>(picture.height), 3,
                         floats ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", floats ? "Linear" : "sRGB");
    spec.attribute("compression", "zip");
    for (const auto &[name, value] : picture.metadata) spec.attribute(name, value);
    const auto failed = [&](const std::string &why) { return SceneError(file + ": cannot write the picture: " + why); };
    if (!output.open(temporary, spec)) throw failed(output.geterror());
    const bool written = floats ? output.write_image(OIIO::TypeDesc::FLOAT, picture.pixels.data())
                                : output.write_image(OIIO::TypeDesc::UINT8, eight_bits(picture.pixels, exposure).data());
    const std::string why = output.geterror();
    if (!output.close() || !written) throw failed(why.empty() ? "the disk may be full" : why);
}

}  // namespace

void check_picture_writable(const std::string &file) {
    output_for(file);
    check_writable(file);
}

void write_picture(const std::string &file, const Picture &picture, float exposure) {
    write_complete(file, [&](const std::string &temporary) { write_pixels(*output_for(file), temporary, file, picture, exposure); });
}

}  // namespace brandung
