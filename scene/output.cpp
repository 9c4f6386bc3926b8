#include "scene/output.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "scene/error.h"

namespace brandung {

namespace fs = std::filesystem;

void check_writable(const std::string &file) {
    const fs::path folder = fs::absolute(file).parent_path();
    if (!fs::is_directory(folder)) throw SceneError(file + ": cannot write there: '" + folder.string() + "' is not a folder");
    if (fs::is_directory(file)) throw SceneError(file + ": cannot write there: it is a folder");
    if (access(folder.c_str(), W_OK) != 0) throw SceneError(file + ": cannot write there: no permission for folder '" + folder.string() + "'");
}

void write_complete(const std::string &file, const std::function<void(const std::string &temporary)> &write) {
    const std::string temporary = file + "." + std::to_string(getpid()) + ".part" + fs::path(file).extension().string();
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
