/// Tokens: words and numbers of a text file, with their lines for errors.
#pragma once
#include <string>
#include <string_view>

#include "kernels/core/portable.h"

namespace brandung {

/// A word as an error message shows it: in quotes, cut, and without what a terminal may take for commands.
std::string quoted(std::string_view word);

/// Words are separated by blanks and line ends, which are those of any system; `#` begins a comment that ends with the line, and a backslash at its
/// end continues it.
class Tokens {
public:
    /// Reads the file. Throws SceneError if it cannot.
    explicit Tokens(const std::string &file);
    /// What has been read of a file, from `offset` on, where line `line` begins.
    Tokens(std::string file, std::string text, std::size_t offset = 0, uint line = 1);
    Tokens(const Tokens &) = delete;
    Tokens &operator=(const Tokens &) = delete;

    /// Whether nothing follows. Goes on to the next word otherwise.
    bool at_end();
    /// Whether something that looks like a number follows, NaN and infinity included.
    bool at_number();
    /// The same, but on the line of the last token.
    bool at_number_on_line();
    /// Whether nothing but a comment follows on the line of the last token.
    bool at_line_end() { return !skip(false); }

    std::string_view word();  ///< empty at the end
    std::string_view peek();  ///< the next word, which stays

    // Of the line of the last token.
    std::string_view word_on_line();  ///< empty at its end
    std::string rest_of_line();       ///< without blanks at both ends; `#` is a letter as others
    void skip_line();

    // Numbers. If none follows, or one that does not fit, the error says that `what` was expected, and what was found.
    float number(const char *what);        ///< finite
    float not_negative(const char *what);  ///< finite
    float length(const char *what);        ///< at most max_magnitude in magnitude, of either sign
    vec3 vector(const char *what);         ///< of three lengths
    /// A length, or NaN for what stands for no number ("nan", "inf", "1.#IND") and for what is too large.
    float any_length(const char *what);
    Spectrum color(const char *what);  ///< of three that are not negative
    int64 integer(const char *what);

    /// The line of the last token, counted from 1.
    uint line() const { return line_; }
    std::size_t left() const { return std::size_t(end_ - at_); }  ///< bytes of the text
    /// The part of the text that has been read.
    double part() const { return text_.empty() ? 1 : double(at_ - text_.data()) / double(text_.size()); }
    /// Throws SceneError `file:line: why`.
    [[noreturn]] void fail(const std::string &why) const { fail_at(line_, why); }
    [[noreturn]] void fail_at(uint line, const std::string &why) const;
    /// The next word in quotes, or "the end of the file".
    std::string found();

private:
    template <class T> T parse(const char *what, const char *expected);
    [[noreturn]] void fail_value(const char *what, const char *expected, std::string_view value) const;
    bool skip(bool over_line_ends);
    const char *continuation(const char *at) const;
    const char *word_end() const;

    std::string file_, text_;
    const char *at_, *end_;
    uint line_ = 1;
};

}  // namespace brandung
