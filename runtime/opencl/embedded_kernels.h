/// The kernels' text inside the program, so that it runs without its source folder.
#pragma once

#include <span>
#include <string_view>

namespace brandung {

/// One file under kernels/: its path in the repository, such as "kernels/core/items.h", and its text.
struct EmbeddedFile {
    std::string_view path, text;
};

/// All files kernels/**/*.h and *.cl, sorted by path.
std::span<const EmbeddedFile> embedded_kernels();

}  // namespace brandung
