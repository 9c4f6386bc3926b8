/// Writing pictures.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/half.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <span>

#include "scene/error.h"
#include "scene/image.h"
#include "scene/output.h"
#include "scene/tone.h"

namespace brandung {
namespace {

namespace fs = std::filesystem;

template <class Integer> std::vector<Integer> integers(const std::vector<vec3> &pixels, const PictureStyle &style) {
    constexpr float largest = std::numeric_limits<Integer>::max();
    const float scale = std::exp2(style.exposure);
    const auto curve = tone_kinds()[style.tone].curve;
    std::vector<Integer> values;
    values.reserve(3 * pixels.size());
    for (const vec3 &pixel : pixels)
        for (int c = 0; c < 3; ++c) values.push_back(static_cast<Integer>(largest * curve(pixel[c] * scale) + 0.5f));
    return values;
}

/// What formats can store, by OpenImageIO's names, each one's own choice first; the others have 8 bits.
const std::map<std::string, std::vector<Bits>> &formats() {
    static const std::map<std::string, std::vector<Bits>> formats = {
        {"openexr", {Bits::single, Bits::half}},
        {"tiff", {Bits::single, Bits::eight, Bits::sixteen}},
        {"hdr", {Bits::single}},
        {"png", {Bits::eight, Bits::sixteen}},
    };
    return formats;
}

std::vector<Bits> bits_of(const OIIO::ImageOutput &output) {
    const auto format = formats().find(output.format_name());
    return format == formats().end() ? std::vector<Bits>{Bits::eight} : format->second;
}

Bits chosen_bits(const OIIO::ImageOutput &output, const PictureStyle &style) {
    const std::vector<Bits> possible = bits_of(output);
    for (const Bits wanted : style.bits)
        if (std::find(possible.begin(), possible.end(), wanted) != possible.end()) return wanted;
    return possible[0];
}

OIIO::TypeDesc type_of(Bits bits) {
    switch (bits) {
        case Bits::eight:
            return OIIO::TypeDesc::UINT8;
        case Bits::sixteen:
            return OIIO::TypeDesc::UINT16;
        case Bits::half:
            return OIIO::TypeDesc::HALF;
        case Bits::single:
            return OIIO::TypeDesc::FLOAT;
    }
    return OIIO::TypeDesc::UNKNOWN;
}

/// Two of OpenImageIO's formats are no files: one forgets the picture, one paints it on the terminal.
bool is_file(const std::string &format) { return format != "null" && format != "term"; }

std::unique_ptr<OIIO::ImageOutput> output_for(const std::string &file) {
    std::error_code ignored;
    if (fs::is_directory(file, ignored)) throw SceneError(file + ": cannot write there: it is a folder");
    if (fs::path(file).extension().empty()) throw SceneError(file + ": cannot write a picture: the name has no extension, try .exr or .png");
    auto output = OIIO::ImageOutput::create(file);
    if (!output || !is_file(output->format_name())) {
        OIIO::geterror();
        throw SceneError(file + ": cannot write pictures of type '" + fs::path(file).extension().string() + "', try .exr or .png");
    }
    return output;
}

SceneError cannot_write(const std::string &file, const std::string &why) {
    return SceneError(file + ": cannot write the picture: " + (why.empty() ? "the disk may be full" : why));
}

bool is_exr(const OIIO::ImageOutput &output) { return output.format_name() == std::string("openexr"); }

/// A file under a temporary name that takes a picture's pixels; errors name the one that it is going to be.
class PictureFile {
public:
    PictureFile(const std::string &file, const std::string &temporary, const Picture &picture, const PictureStyle &style)
        : file_(file), output_(output_for(file)), bits_(chosen_bits(*output_, style)) {
        const bool linear = floats() || tone_kinds()[style.tone].linear, jpeg = output_->format_name() == std::string("jpeg");
        OIIO::ImageSpec spec(static_cast<int>(picture.width), static_cast<int>(picture.height), 3, type_of(bits_));
        spec.attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
        spec.attribute("compression", jpeg ? "jpeg:" + std::to_string(style.quality) : "zip");
        for (const auto &[name, value] : picture.metadata) spec.attribute(name, value);
        if (is_exr(*output_) && picture.whole_width > 0) set_place(picture, spec);
        if (is_exr(*output_)) add_channels(picture, spec);
        if (!output_->open(temporary, spec)) throw cannot_write(file_, output_->geterror());
    }

    void write(const Picture &picture, const PictureStyle &style) {
        const std::vector<vec3> &pixels = picture.pixels;
        if (is_exr(*output_) && !picture.channels.empty()) return finish(output_->write_image(OIIO::TypeDesc::UNKNOWN, packed(picture).data()));
        if (floats()) return finish(output_->write_image(OIIO::TypeDesc::FLOAT, pixels.data()));
        if (bits_ == Bits::eight) return finish(output_->write_image(OIIO::TypeDesc::UINT8, integers<std::uint8_t>(pixels, style).data()));
        finish(output_->write_image(OIIO::TypeDesc::UINT16, integers<std::uint16_t>(pixels, style).data()));
    }

private:
    bool floats() const { return bits_ == Bits::half || bits_ == Bits::single; }

    static void add_channels(const Picture &picture, OIIO::ImageSpec &spec) {
        spec.channelformats.assign(3, spec.format);
        for (const PictureChannel &channel : picture.channels) {
            spec.channelnames.push_back(channel.name);
            spec.channelformats.push_back(channel.numbers.empty() ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT);
        }
        spec.nchannels = static_cast<int>(spec.channelnames.size());
    }

    /// All channels of a pixel, then those of the next, as the file stores them.
    std::vector<std::byte> packed(const Picture &picture) const {
        std::vector<std::byte> bytes;
        const auto add = [&](auto value) {
            const auto part = std::as_bytes(std::span(&value, 1));
            bytes.insert(bytes.end(), part.begin(), part.end());
        };
        for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
            for (int c = 0; c < 3; ++c) {
                const float value = picture.pixels[i][c];
                bits_ == Bits::half ? add(half(value)) : add(value);
            }
            for (const PictureChannel &channel : picture.channels) channel.numbers.empty() ? add(channel.floats[i]) : add(channel.numbers[i]);
        }
        return bytes;
    }

    static void set_place(const Picture &picture, OIIO::ImageSpec &spec) {
        spec.x = static_cast<int>(picture.left), spec.y = static_cast<int>(picture.top);
        spec.full_width = static_cast<int>(picture.whole_width), spec.full_height = static_cast<int>(picture.whole_height);
    }

    void finish(bool written) {
        const std::string why = output_->geterror();
        if (!output_->close() || !written) throw cannot_write(file_, why);
    }

    const std::string &file_;
    std::unique_ptr<OIIO::ImageOutput> output_;
    Bits bits_;
};

/// What is written to standard error while this lives is lost.
class Silence {
public:
    Silence() : kept_(dup(STDERR_FILENO)), nothing_(open("/dev/null", O_WRONLY)) { dup2(nothing_, STDERR_FILENO); }
    ~Silence() {
        dup2(kept_, STDERR_FILENO);
        close(kept_), close(nothing_);
    }
    Silence(const Silence &) = delete;

private:
    int kept_, nothing_;
};

}  // namespace

const std::vector<std::string> &names_of_bits() {
    static const std::vector<std::string> names = {"8", "16", "half", "float"};
    return names;
}

void check_picture_writable(const std::string &file, uint width, uint height, const PictureStyle &style) {
    output_for(file);
    check_writable(file);
    try_writing(file, [&](const std::string &temporary) {
        const Silence silence;  // libpng complains aloud of a file that is closed without pixels
        PictureFile(file, temporary, {width, height, {}, {}}, style);
    });
}

bool stores_metadata(const std::string &file) {
    const auto output = output_for(file);
    // PNG stores texts of any name, but OpenImageIO means all types.
    return output->supports("arbitrary_metadata") || output->format_name() == std::string("png");
}

std::vector<Bits> bits_of_format(const std::string &file) { return bits_of(*output_for(file)); }

bool stores_channels(const std::string &file) { return is_exr(*output_for(file)); }

bool is_jpeg(const std::string &file) { return output_for(file)->format_name() == std::string("jpeg"); }

void write_picture(const std::string &file, const Picture &picture, const PictureStyle &style) {
    write_complete(file, [&](const std::string &temporary) { PictureFile(file, temporary, picture, style).write(picture, style); });
}

std::vector<unsigned char> png_bytes(const Picture &picture, const PictureStyle &style) {
    const auto output = OIIO::ImageOutput::create("png");
    OIIO::ImageSpec spec(static_cast<int>(picture.width), static_cast<int>(picture.height), 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", tone_kinds()[style.tone].linear ? "Linear" : "sRGB");
    spec.attribute("png:compressionLevel", 1);
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const bool written = output && output->set_ioproxy(&memory) && output->open("picture.png", spec) &&
                         output->write_image(OIIO::TypeDesc::UINT8, integers<std::uint8_t>(picture.pixels, style).data()) && output->close();
    if (!written) throw SceneError("cannot make a PNG in memory: " + (output ? output->geterror() : OIIO::geterror()));
    return bytes;
}

}  // namespace brandung
