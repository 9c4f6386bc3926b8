#include "runtime/opencl/kernel_cache.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

namespace brandung {
namespace {

namespace fs = std::filesystem;

/// As PoCL chooses it; empty where the environment names none.
fs::path cache_folder() {
    if (const char *folder = std::getenv("POCL_CACHE_DIR")) return folder;
    if (const char *folder = std::getenv("XDG_CACHE_HOME")) return fs::path(folder) / "pocl";
    if (const char *folder = std::getenv("HOME")) return fs::path(folder) / ".cache" / "pocl";
    return {};
}

/// Why nothing can be written there; empty if something can.
std::string why_unwritable(const fs::path &folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return error.message();
    const std::string file = folder / ("brandung." + std::to_string(getpid()));
    const int descriptor = open(file.c_str(), O_CREAT | O_EXCL | O_WRONLY, 0600);
    if (descriptor < 0) return std::strerror(errno);
    close(descriptor);
    fs::remove(file, error);
    return "";
}

}  // namespace

std::string kernel_cache_fault() {
    const fs::path folder = cache_folder();
    const std::string why = folder.empty() ? "" : why_unwritable(folder);
    if (why.empty()) return "";
    return "PoCL cannot write its kernel cache " + folder.string() + " (" + why + "); set POCL_CACHE_DIR to a folder that it can write";
}

}  // namespace brandung
