/// Writing pictures.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "scene/error.h"
#include "scene/image.h"
#include "scene/output.h"
#include "scene/tone.h"

namespace brandung {
namespace {

namespace fs = std::filesystem;

std::vector<std::uint8_t> eight_bits(const std::vector<vec3> &pixels, float exposure) {
    const float scale = std::exp2(exposure);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * pixels.size());
    for (const vec3 &pixel : pixels)
        for (int c = 0; c < 3; ++c) bytes.push_back(static_cast<std::uint8_t>(255 * srgb_encoded(glm::clamp(pixel[c] * scale, 0.0f, 1.0f)) + 0.5f));
    return bytes;
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

/// A file under a temporary name that takes a picture's pixels; errors name the one that it is going to be.
class PictureFile {
public:
    PictureFile(const std::string &file, const std::string &temporary, uint width, uint height, const std::map<std::string, std::string> &metadata)
        : file_(file), output_(output_for(file)) {
        // These store what they are asked for, the others what they always do.
        const std::string format = output_->format_name();
        const bool floats = format == "openexr" || format == "tiff";
        OIIO::ImageSpec spec(static_cast<int>(width), static_cast<int>(height), 3, floats ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
        spec.attribute("oiio:ColorSpace", floats ? "Linear" : "sRGB");
        spec.attribute("compression", "zip");
        for (const auto &[name, value] : metadata) spec.attribute(name, value);
        if (!output_->open(temporary, spec)) throw cannot_write(file_, output_->geterror());
    }

    /// Whether the file stores floats.
    bool floats() const { return output_->spec().format.is_floating_point(); }

    void write(const std::vector<vec3> &pixels) { finish(output_->write_image(OIIO::TypeDesc::FLOAT, pixels.data())); }
    void write(const std::vector<std::uint8_t> &bytes) { finish(output_->write_image(OIIO::TypeDesc::UINT8, bytes.data())); }

private:
    void finish(bool written) {
        const std::string why = output_->geterror();
        if (!output_->close() || !written) throw cannot_write(file_, why);
    }

    const std::string &file_;
    std::unique_ptr<OIIO::ImageOutput> output_;
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

void check_picture_writable(const std::string &file, uint width, uint height) {
    output_for(file);
    check_writable(file);
    try_writing(file, [&](const std::string &temporary) {
        const Silence silence;  // libpng complains aloud of a file that is closed without pixels
        PictureFile(file, temporary, width, height, {});
    });
}

bool stores_metadata(const std::string &file) {
    const auto output = output_for(file);
    // PNG stores texts of any name, but OpenImageIO means all types.
    return output->supports("arbitrary_metadata") || output->format_name() == std::string("png");
}

void write_picture(const std::string &file, const Picture &picture, float exposure) {
    write_complete(file, [&](const std::string &temporary) {
        PictureFile opened(file, temporary, picture.width, picture.height, picture.metadata);
        opened.floats() ? opened.write(picture.pixels) : opened.write(eight_bits(picture.pixels, exposure));
    });
}

std::vector<unsigned char> png_bytes(const Picture &picture, float exposure) {
    const auto output = OIIO::ImageOutput::create("png");
    OIIO::ImageSpec spec(static_cast<int>(picture.width), static_cast<int>(picture.height), 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("png:compressionLevel", 1);
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const bool written = output && output->set_ioproxy(&memory) && output->open("picture.png", spec) &&
                         output->write_image(OIIO::TypeDesc::UINT8, eight_bits(picture.pixels, exposure).data()) && output->close();
    if (!written) throw SceneError("cannot make a PNG in memory: " + (output ? output->geterror() : OIIO::geterror()));
    return bytes;
}

}  // namespace brandung
