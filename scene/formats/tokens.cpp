/// Words and numbers of a text file.
#include "scene/formats/tokens.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "scene/error.h"
#include "scene/input.h"
#include "scene/parameters.h"

namespace brandung {
namespace {

bool is_blank(char c) { return c == ' ' || ('\t' <= c && c <= '\r'); }
bool ends_word(char c) { return is_blank(c) || c == '#'; }
bool is_digit(char c) { return '0' <= c && c <= '9'; }

}  // namespace

std::string quoted(std::string_view word) {
    std::string result = "\"";
    for (const char c : word.substr(0, 32)) result += ' ' <= c && c <= '~' ? c : '?';
    return result + (word.size() > 32 ? "...\"" : "\"");
}

Tokens::Tokens(const std::string &file) : Tokens(file, file_text(file)) {}

Tokens::Tokens(std::string file, std::string text, std::size_t offset, uint line)
    : file_(std::move(file)), text_(std::move(text)), at_(text_.data() + offset), end_(text_.data() + text_.size()), line_(line) {
    // Lines that end with a carriage return alone, as the Macintosh had them.
    if (text_.find('\n') == std::string::npos) std::replace(text_.begin(), text_.end(), '\r', '\n');
}

void Tokens::fail_at(uint line, const std::string &why) const { throw SceneError(fmt::format("{}:{}: {}", file_, line, why)); }

void Tokens::fail_value(const char *what, const char *expected, std::string_view value) const {
    fail(fmt::format("{}: expected {}, found {}", what, expected, quoted(value)));
}

/// Where the next line begins if a backslash at `at` continues the line; null if not.
const char *Tokens::continuation(const char *at) const {
    if (*at != '\\' || at + 1 == end_) return nullptr;
    const char *next = at + 1;
    if (*next == '\r' && next + 1 != end_) ++next;
    return *next == '\n' ? next + 1 : nullptr;
}

const char *Tokens::word_end() const {
    const char *end = at_;
    while (end != end_ && !ends_word(*end) && !continuation(end)) ++end;
    return end;
}

/// Goes on to the next word; false if there is none, or none on this line.
bool Tokens::skip(bool over_line_ends) {
    while (at_ != end_) {
        if (*at_ == '#') {
            at_ = std::find(at_, end_, '\n');
        } else if (*at_ == '\n') {
            if (!over_line_ends) return false;
            ++line_, ++at_;
        } else if (is_blank(*at_)) {
            ++at_;
        } else if (const char *next = continuation(at_)) {
            ++line_, at_ = next;
        } else {
            return true;
        }
    }
    return false;
}

bool Tokens::at_end() { return !skip(true); }

bool Tokens::at_number() {
    const std::string_view next = peek();
    if (next.empty()) return false;
    const std::string_view digits = next.substr(next[0] == '+' || next[0] == '-' ? 1 : 0);
    const auto begins_with = [&](std::string_view name) { return digits.substr(0, name.size()) == name; };
    if (!digits.empty() && (is_digit(digits[0]) || digits[0] == '.')) return true;
    return begins_with("nan") || begins_with("NaN") || begins_with("NAN") || begins_with("inf") || begins_with("Inf") || begins_with("INF");
}

bool Tokens::at_number_on_line() { return skip(false) && at_number(); }

std::string_view Tokens::peek() {
    if (at_end()) return {};
    return {at_, std::size_t(word_end() - at_)};
}

std::string_view Tokens::word_on_line() { return at_line_end() ? std::string_view() : word(); }

std::string Tokens::rest_of_line() {
    while (at_ != end_ && *at_ != '\n' && is_blank(*at_)) ++at_;
    const char *const begin = at_;
    at_ = std::find(at_, end_, '\n');
    const char *end = at_;
    while (end != begin && is_blank(end[-1])) --end;
    return {begin, end};
}

void Tokens::skip_line() {
    while (at_ != end_ && *at_ != '\n') {
        if (const char *next = continuation(at_))
            ++line_, at_ = next;
        else
            ++at_;
    }
}

std::string_view Tokens::word() {
    const std::string_view result = peek();
    at_ += result.size();
    return result;
}

std::string Tokens::found() {
    const std::string_view next = peek();
    return next.empty() ? "the end of the file" : quoted(next);
}

template <class T> T Tokens::parse(const char *what, const char *expected) {
    if (at_end()) fail(fmt::format("{}: expected {}, found the end of the file", what, expected));
    T value{};
    // from_chars takes no plus sign, but printf can write one.
    const bool plus = *at_ == '+' && end_ - at_ > 1 && (is_digit(at_[1]) || at_[1] == '.');
    const auto [stop, error] = std::from_chars(at_ + plus, end_, value);
    if (error != std::errc() || (stop != end_ && !ends_word(*stop) && !continuation(stop))) fail_value(what, expected, peek());
    at_ = stop;
    return value;
}

float Tokens::number(const char *what) {
    constexpr const char *expected = "a finite number in the range of a float";
    const char *const begin = (at_end(), at_);
    const double value = parse<double>(what, expected);
    if (!(std::abs(value) <= std::numeric_limits<float>::max())) fail_value(what, expected, {begin, std::size_t(at_ - begin)});
    return float(value);
}

float Tokens::not_negative(const char *what) {
    const float value = number(what);
    if (value < 0) fail(fmt::format("{}: must not be negative, got {:g}", what, value));
    return value;
}

float Tokens::length(const char *what) {
    const float value = number(what);
    if (std::abs(value) > max_magnitude) fail(fmt::format("{}: must be at most {:g} in magnitude, got {:g}", what, max_magnitude, value));
    return value;
}

float Tokens::any_length(const char *what) {
    const std::string_view next = peek();
    double value{};
    const bool plus = next.starts_with('+');
    const auto [stop, error] = std::from_chars(next.data() + plus, next.data() + next.size(), value);
    const bool names_none = stop != end_ && *stop == '#';  // "1.#IND", which to others begins a comment
    if (error == std::errc::result_out_of_range || names_none) {
        at_ += next.size();
        while (at_ != end_ && !is_blank(*at_)) ++at_;
        return std::numeric_limits<float>::quiet_NaN();
    }
    if (error != std::errc() || stop != next.data() + next.size()) fail_value(what, "a number", next);
    at_ = stop;
    return std::abs(value) <= max_magnitude ? float(value) : std::numeric_limits<float>::quiet_NaN();
}

vec3 Tokens::vector(const char *what) {
    const float x = length(what), y = length(what), z = length(what);
    return {x, y, z};
}

Spectrum Tokens::color(const char *what) {
    const float red = not_negative(what), green = not_negative(what), blue = not_negative(what);
    return {red, green, blue};
}

int64 Tokens::integer(const char *what) { return parse<int64>(what, "a whole number"); }

}  // namespace brandung
