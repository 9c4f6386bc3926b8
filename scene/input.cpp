#include "scene/input.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "scene/error.h"

namespace brandung {

namespace fs = std::filesystem;

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";  ///< of UTF-8, before texts of some editors

void check_readable(const std::string &file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found) throw SceneError(file + ": no such file");
    if (error) throw SceneError(file + ": cannot be read: " + error.message());
    if (fs::is_directory(status)) throw SceneError(file + ": is a folder, not a file");
    if (!std::ifstream(file)) throw SceneError(file + ": cannot be opened for reading");
    // A pipe has no size to ask for.
    if (fs::is_regular_file(status) && fs::file_size(file, error) == 0) throw SceneError(file + ": is empty");
}

std::string file_text(const std::string &file) {
    check_readable(file);
    std::ifstream stream(file, std::ios::binary);
    std::string text;
    char part[1 << 16];
    while (stream.read(part, sizeof part) || stream.gcount() > 0) text.append(part, static_cast<std::size_t>(stream.gcount()));
    if (stream.bad()) throw SceneError(file + ": cannot be read: " + std::strerror(errno));
    if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
    return text;
}

}  // namespace brandung
