/// Pictures as files have them, for comparisons with what was to be stored.
#pragma once
#include <OpenImageIO/imageio.h>

#include <string>
#include <vector>

/// A picture as it lies on disk; 8-bit values become fractions of 255.
struct StoredPicture {
    OIIO::ImageSpec spec;
    std::vector<float> values;

    std::string text(const char *name) const { return spec.get_string_attribute(name); }
};

/// Throws std::runtime_error.
StoredPicture read_stored(const std::string &file);
