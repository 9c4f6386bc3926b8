#include "scene/output.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "scene/error.h"

namespace brandung {
namespace {

namespace fs = std::filesystem;

/// File systems take 255 bytes; a name's beginning leaves room for what a temporary one has more.
constexpr std::size_t kept_of_name = 200;

/// More links than any system follows.
constexpr int most_links = 64;

std::string temporary_name(const std::string &file) {
    const fs::path path(linked_file(file));
    const std::string name = path.filename().string().substr(0, kept_of_name) + "." + std::to_string(getpid()) + ".part";
    return (path.parent_path() / (name + fs::path(file).extension().string())).string();
}

SceneError cannot_write(const std::string &file, const std::string &why) { return SceneError(file + ": cannot write there: " + why); }

/// Calls `write`; removes what it wrote if it throws.
void write_or_remove(const std::string &temporary, const WriteFile &write) {
    try {
        write(temporary);
    } catch (...) {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw;
    }
}

/// What the temporary name does not tell: it may be shorter than the file's own, and is no folder.
void check_name(const std::string &file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (fs::is_directory(status)) throw cannot_write(file, "it is a folder");
    if (status.type() != fs::file_type::not_found && error) throw cannot_write(file, error.message());
    const fs::path folder = fs::path(linked_file(file)).parent_path();
    if (!folder.empty() && !fs::is_directory(folder, error)) throw cannot_write(file, "'" + folder.string() + "' is not a folder");
}

}  // namespace

std::string linked_file(const std::string &name) {
    fs::path file(name);
    std::error_code error;
    for (int links = 0; links < most_links && fs::is_symlink(file, error); ++links) file = file.parent_path() / fs::read_symlink(file, error);
    return file.string();
}

void try_writing(const std::string &file, const WriteFile &write) {
    check_name(file);
    const std::string temporary = temporary_name(file);
    write_or_remove(temporary, write);
    std::error_code ignored;
    fs::remove(temporary, ignored);
}

void check_writable(const std::string &file) {
    try_writing(file, [&](const std::string &temporary) {
        if (!std::ofstream(temporary)) throw cannot_write(file, std::strerror(errno));
    });
}

void write_complete(const std::string &file, const WriteFile &write) {
    const std::string temporary = temporary_name(file);
    write_or_remove(temporary, [&](const std::string &name) {
        write(name);
        std::error_code error;
        fs::rename(name, linked_file(file), error);
        if (error) throw cannot_write(file, error.message());
    });
}

void write_text(const std::string &file, const std::string &text) {
    write_complete(file, [&](const std::string &temporary) {
        std::ofstream out(temporary);
        out << text;
        if (!out.flush()) throw cannot_write(file, "the disk may be full");
    });
}

}  // namespace brandung
