#include "scene/output.h"

#include <fcntl.h>
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

/// Bytes of a growing text that are kept until they are written.
constexpr std::size_t worth_writing = 1 << 16;

/// More links than any system follows.
constexpr int most_links = 64;

std::string temporary_name(const std::string &file) {
    const fs::path path(linked_file(file));
    const std::string name = path.filename().string().substr(0, kept_of_name) + "." + std::to_string(getpid()) + ".part";
    return (path.parent_path() / (name + fs::path(file).extension().string())).string();
}

SceneError cannot_write(const std::string &file, const std::string &why) { return SceneError(file + ": cannot write there: " + why); }

void rename_to(const std::string &file, const std::string &temporary) {
    std::error_code error;
    fs::rename(temporary, linked_file(file), error);
    if (error) throw cannot_write(file, error.message());
}

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
        rename_to(file, name);
    });
}

void write_text(const std::string &file, const std::string &text) {
    write_complete(file, [&](const std::string &temporary) {
        std::ofstream out(temporary);
        out << text;
        if (!out.flush()) throw cannot_write(file, "the disk may be full");
    });
}

GrowingText::GrowingText(const std::string &file, const std::string &ending)
    : file_(file), temporary_(temporary_name(file)), ending_(ending), descriptor_(open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666)) {
    if (descriptor_ < 0) throw cannot_write(file, std::strerror(errno));
}

GrowingText::~GrowingText() {
    if (descriptor_ < 0) return;
    close(descriptor_);
    std::error_code ignored;
    fs::remove(temporary_, ignored);
}

void GrowingText::append(std::string_view text) {
    waiting_ += text;
    if (waiting_.size() >= worth_writing) write();
}

/// In one call, so that no signal comes between a part and the ending, over which the next part goes.
void GrowingText::write() {
    const std::size_t added = waiting_.size();
    waiting_ += ending_;
    const ssize_t bytes = fault_.empty() ? pwrite(descriptor_, waiting_.data(), waiting_.size(), written_) : 0;
    if (bytes != static_cast<ssize_t>(waiting_.size()) && fault_.empty()) fault_ = bytes < 0 ? std::strerror(errno) : "the disk may be full";
    written_ += static_cast<std::int64_t>(added);
    waiting_.clear();
}

void GrowingText::finish() {
    write();
    if (!fault_.empty()) throw cannot_write(file_, fault_);
    rename_to(file_, temporary_);
    close(descriptor_);
    descriptor_ = -1;
}

}  // namespace brandung
