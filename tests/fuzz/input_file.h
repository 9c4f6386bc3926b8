/// What a fuzzer makes up, as the file that a reader wants.
#pragma once
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "scene/error.h"

/// Writes the file of this process, and gives its path.
inline std::string write_input(const std::uint8_t *data, std::size_t size, const std::string &extension) {
    static const std::string file = (std::filesystem::temp_directory_path() / ("brandung-fuzz-" + std::to_string(getpid()) + extension)).string();
    std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char *>(data), static_cast<std::streamsize>(size));
    return file;
}
