#include "tests/tools/stored_picture.h"

#include <stdexcept>

StoredPicture read_stored(const std::string &file) {
    const auto input = OIIO::ImageInput::open(file);
    if (!input) throw std::runtime_error(file + ": " + OIIO::geterror());
    StoredPicture picture{input->spec(), {}};
    picture.values.resize(static_cast<std::size_t>(picture.spec.width) * picture.spec.height * picture.spec.nchannels);
    if (!input->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, picture.values.data())) throw std::runtime_error(file + ": " + input->geterror());
    return picture;
}
