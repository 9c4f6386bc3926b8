/// Files that are read.
#pragma once
#include <functional>
#include <string>

namespace brandung {

/// Told now and then how far a file has been read; `part` is from 0 to 1.
using ReadProgress = std::function<void(const std::string &file, double part)>;

/// Throws SceneError if the file does not exist, is a folder, is empty or cannot be opened.
void check_readable(const std::string &file);
/// All bytes of a file, without UTF-8's byte order mark. Throws SceneError if it cannot be read.
std::string file_text(const std::string &file);

}  // namespace brandung
