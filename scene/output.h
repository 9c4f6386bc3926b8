/// Files that appear under their name only when they are complete.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

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

/// A text that is written as it grows, under such a temporary name until it is complete. Whenever the program may end, the file there ends with
/// `ending`.
class GrowingText {
public:
    /// Throws SceneError if no file can be written there.
    GrowingText(const std::string &file, const std::string &ending);
    /// Removes what is not complete.
    ~GrowingText();
    GrowingText(const GrowingText &) = delete;

    /// Writes when enough has come together to be worth it. Faults are told by finish().
    void append(std::string_view text);
    /// Gives the file its name. Throws SceneError if not all of it could be written.
    void finish();

private:
    void write();

    std::string file_, temporary_, ending_, waiting_;
    int descriptor_;
    std::int64_t written_ = 0;  ///< bytes, without the ending
    std::string fault_;
};

}  // namespace brandung
