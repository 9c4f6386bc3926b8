/// Files that appear under their name only when they are complete.
#pragma once
#include <functional>
#include <string>

namespace brandung {

/// Writes to the file of that name.
using WriteFile = std::function<void(const std::string &name)>;

/// The file itself, where the name is one of symbolic links that lead to it; it need not exist.
std::string linked_file(const std::string &name);

/// Calls `write` with a temporary name beside the file itself and with the extension of its name, and removes what it wrote. Throws SceneError if no
/// file could be written there, and what `write` throws.
void try_writing(const std::string &file, const WriteFile &write);
/// Throws SceneError if no file could be written there.
void check_writable(const std::string &file);
/// Calls `write` with such a temporary name, then renames; links stay links. After an exception nothing is left. Throws SceneError, and what `write`
/// throws.
void write_complete(const std::string &file, const WriteFile &write);
/// Throws SceneError.
void write_text(const std::string &file, const std::string &text);

}  // namespace brandung
