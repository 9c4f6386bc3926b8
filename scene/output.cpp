#include "scene/output.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "scene/error.h"

namespace brandung {

namespace fs = std::filesystem;

namespace {

std::string temporary_name(const std::string &file) { return file + "." + std::to_string(getpid()) + ".part" + fs::path(file).extension().string(); }

}  // namespace

void check_writable(const std::string &file) {
    const fs::path folder = fs::absolute(file).parent_path();
    if (!fs::is_directory(folder)) throw SceneError(file + ": cannot write there: '" + folder.string() + "' is not a folder");
    if (fs::is_directory(file)) throw SceneError(file + ": cannot write there: it is a folder");
    const std::string probe = temporary_name(file);
    const bool opens = std::ofstream(probe).is_open();
    const std::string why = std::strerror(errno);
    if (!opens) throw SceneError(file + ": cannot write there: " + why);
    fs::remove(probe);
}

void write_complete(const std::string &file, const std::function<void(const std::string &temporary)> &write) {
    const std::string temporary = temporary_name(file);
    try {
        write(temporary);
        fs::rename(temporary, file);
    } catch (...) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw;
    }
}

void write_text(const std::string &file, const std::string &text) {
    write_complete(file, [&](const std::string &temporary) {
        std::ofstream out(temporary);
        out << text;
        if (!out.flush()) throw SceneError(file + ": cannot write there: the disk may be full");
    });
}

}  // namespace brandung
