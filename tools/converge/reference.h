/// Reference: the picture that errors are measured from, and what is known of it.
#pragma once
#include <optional>

#include "scene/image.h"
#include "tools/converge/way.h"

namespace brandung {

struct ReferencePicture {
    Picture picture;
    std::string name;
    std::optional<double> noise = {};  ///< its own, relMSE
    std::optional<Way> way = {};       ///< how it was rendered
    std::optional<uint> seed = {};     ///< of its random numbers, which no other picture may have
};

/// A picture of this program says in its metadata how it was rendered. Throws SceneError.
ReferencePicture read_reference(const std::string &file);
/// So that read_reference() finds all of it again; in a format that stores floats and metadata. Throws SceneError.
void write_reference(const std::string &file, const ReferencePicture &reference);
/// Throws SceneError if that could not be written.
void check_reference_writable(const std::string &file, uint width, uint height);

}  // namespace brandung
