/// Files that appear under their name only when they are complete.
#pragma once
#include <functional>
#include <string>

namespace brandung {

/// Throws SceneError if no file could be written there.
void check_writable(const std::string &file);
/// Calls `write` with a temporary name beside the file's own and with its extension, then renames. After an exception nothing is left.
void write_complete(const std::string &file, const std::function<void(const std::string &temporary)> &write);
/// Throws SceneError.
void write_text(const std::string &file, const std::string &text);

}  // namespace brandung
