/// Tokens: words and numbers of a text file, with their lines for errors.
#pragma once
#include <string>
#include <string_view>

#include "kernels/core/portable.h"

namespace brandung {

/// A word as an error message shows it: in quotes, cut, and without what a terminal may take for commands.
std::string quoted(std::string_view word);

/// Words are separated by blanks and line ends; `#` begins a comment that ends with the line.
class Tokens {
public:
    /// Reads the file. Throws SceneError if it cannot.
    explicit Tokens(const std::string &file);
    Tokens(const Tokens &) = delete;
    Tokens &operator=(const Tokens &) = delete;

    /// Whether nothing follows. Goes on to the next word otherwise.
    bool at_end();
    /// Whether something that looks like a number follows, NaN and infinity included.
    bool at_number();
    /// The same, but on the line of the last token.
    bool at_number_on_line();

    std::string_view word();  ///< empty at the end
    std::string_view peek();  ///< the next word, which stays

    // Numbers. If none follows, or one that does not fit, the error says that `what` was expected, and what was found.
    float number(const char *what);        ///< finite
    float not_negative(const char *what);  ///< finite
    float length(const char *what);        ///< at most max_magnitude in magnitude, of either sign
    vec3 vector(const char *what);         ///< of three lengths
    Spectrum color(const char *what);      ///< of three that are not negative
    int64 integer(const char *what);

    /// The line of the last token, counted from 1.
    uint line() const { return line_; }
    /// Throws SceneError `file:line: why`.
    [[noreturn]] void fail(const std::string &why) const { fail_at(line_, why); }
    [[noreturn]] void fail_at(uint line, const std::string &why) const;
    /// The next word in quotes, or "the end of the file".
    std::string found();

private:
    template <class T> T parse(const char *what, const char *expected);
    [[noreturn]] void fail_value(const char *what, const char *expected, std::string_view value) const;
    bool skip(bool over_line_ends);

    std::string file_, text_;
    const char *at_, *end_;
    uint line_ = 1;
};

}  // namespace brandung
