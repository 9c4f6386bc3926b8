/// Files that are read.
#pragma once
#include <string>

namespace brandung {

/// Throws SceneError if the file does not exist, is a folder, is empty or cannot be opened.
void check_readable(const std::string &file);
/// All bytes of a file. Throws SceneError if it cannot be read.
std::string file_text(const std::string &file);

}  // namespace brandung
