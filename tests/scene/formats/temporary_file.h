/// Files that a test writes.
#pragma once
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "scene/formats/format.h"

namespace brandung {

/// A file with the given contents for as long as it lives.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::string &text, const std::string &extension = ".json")
        : path(std::filesystem::temp_directory_path() / ("brandung-" + std::to_string(getpid()) + extension)) {
        std::ofstream(path, std::ios::binary) << text;
    }
    ~TemporaryFile() { std::filesystem::remove(path); }
    TemporaryFile(const TemporaryFile &) = delete;
    TemporaryFile &operator=(const TemporaryFile &) = delete;

    const std::string path;
};

inline Scene read_text(const std::string &text, const std::vector<std::string> &assignments = {}) {
    const TemporaryFile file(text);
    return read_scene(file.path, {assignments, {}, {}});
}

}  // namespace brandung
