/// JSON text to Document, with errors that name file, line and cause.
#include "scene/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <vector>

#include "scene/error.h"
#include "scene/input.h"

namespace brandung {
namespace {

using nlohmann::json;

constexpr std::size_t max_nesting = 64;
constexpr std::size_t max_message = 400;

/// An iterator over the text; `reached` tells how far the parser has read, of which it may have read one character ahead.
struct Cursor {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char *;
    using reference = const char &;

    const char *at;
    const char **reached;

    reference operator*() const { return *at; }
    Cursor &operator++() {
        *reached = ++at;
        return *this;
    }
    bool operator==(const Cursor &other) const { return at == other.at; }
};

/// One line of at most max_message bytes.
std::string printable(std::string text) {
    if (text.size() > max_message) {
        text.resize(max_message);
        text += " ...";
    }
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, ' ');
    return text;
}

/// The parser's own words without its error numbers and its column.
std::string cause(const std::string &message) {
    const std::size_t place = message.find("parse error at ");
    const std::size_t start = place == std::string::npos ? message.find("] ") : message.find(": ", place);
    return start == std::string::npos ? message : message.substr(start + 2);
}

/// Builds the values, refuses duplicate keys; where `wanted` is given, ends at the value with that pointer.
class Reader : public nlohmann::json_sax<json> {
public:
    Reader(const std::string &file, const std::string &text, std::optional<std::string> wanted = {})
        : file_(file), text_(text), wanted_(std::move(wanted)), reached_(text.data()) {}

    json read() {
        const char *end = text_.data() + text_.size();
        json::sax_parse(Cursor{text_.data(), &reached_}, Cursor{end, &reached_}, this);
        return std::move(root_);
    }
    std::optional<std::size_t> found_line() const { return found_line_; }

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(std::int64_t value) override { return add(value); }
    bool number_unsigned(std::uint64_t value) override { return add(value); }
    bool number_float(double value, const std::string &) override { return add(value); }
    bool string(std::string &value) override { return add(std::move(value)); }
    bool binary(json::binary_t &) override { return false; }
    bool start_object(std::size_t) override { return open(json::object()); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(std::string &key) override {
        if (levels_.back().value->contains(key)) refuse("duplicate key \"" + key + "\"");
        levels_.back().key = std::move(key);
        return true;
    }
    bool parse_error(std::size_t position, const std::string &, const json::exception &error) override {
        reached_ = text_.data() + std::min(position, text_.size());
        throw SceneError(printable(file_ + ":" + std::to_string(line()) + ": " + cause(error.what())));
    }

private:
    struct Level {
        json *value;
        std::string key;  ///< of the member that comes next
    };

    std::size_t line() const {
        const char *last = std::max(text_.data() + 1, reached_) - 1;
        return 1 + static_cast<std::size_t>(std::count(text_.data(), last, '\n'));
    }
    std::string pointer() const {
        std::string result;
        for (const Level &level : levels_)
            result += "/" + (level.value->is_array() ? std::to_string(level.value->size() - 1) : pointer_step(level.key));
        return result;
    }
    [[noreturn]] void refuse(const std::string &why) const { throw SceneError(printable(file_ + ":" + std::to_string(line()) + ": " + why)); }

    json *place(json value) {
        if (levels_.empty()) return &(root_ = std::move(value));
        json &parent = *levels_.back().value;
        if (!parent.is_array()) return &(parent[levels_.back().key] = std::move(value));
        parent.push_back(std::move(value));
        return &parent.back();
    }
    bool add(json value) {
        place(std::move(value));
        return !is_wanted();
    }
    bool open(json value) {
        if (levels_.size() == max_nesting) refuse("nested deeper than " + std::to_string(max_nesting) + " levels");
        json *placed = place(std::move(value));
        const bool goes_on = !is_wanted();
        levels_.push_back({placed, {}});
        return goes_on;
    }
    bool close() {
        levels_.pop_back();
        return true;
    }
    bool is_wanted() {
        const bool here = wanted_ && pointer() == *wanted_;
        if (here) found_line_ = line();
        return here;
    }

    const std::string &file_, &text_;
    std::optional<std::string> wanted_;
    const char *reached_;
    json root_;
    std::vector<Level> levels_;
    std::optional<std::size_t> found_line_;
};

bool is_at_or_below(const std::string &pointer, const std::string &ancestor) {
    return pointer.starts_with(ancestor) && (pointer.size() == ancestor.size() || pointer[ancestor.size()] == '/');
}

/// Where the file has the value with this pointer; nothing if it has none.
std::optional<std::size_t> line_of(const Document &document, const std::string &pointer) {
    if (document.text.empty()) return {};  // settings of a file of another format
    Reader reader(document.file, document.text, pointer);
    reader.read();
    return reader.found_line();
}

/// The member or element `step` of `value`, made if it is a new member; null if there can be none.
json *step_into(json &value, const std::string &step) {
    if (value.is_object()) return &value.emplace(step, json::object()).first.value();
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), index);
    const bool whole = error == std::errc() && end == step.data() + step.size();
    return value.is_array() && whole && index < value.size() ? &value[index] : nullptr;
}

}  // namespace

Document read_document(const std::string &file) { return parse_document(file, file_text(file)); }

Document parse_document(std::string file, std::string text) {
    Document document{std::move(file), std::move(text), {}, {}, {}};
    document.root = Reader(document.file, document.text).read();
    return document;
}

void set_value(Document &document, const std::string &assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) throw SceneError(printable("\"" + assignment + "\": a setting has the form KEY=VALUE"));
    std::string pointer;
    json *value = &document.root;
    for (std::size_t start = 0, end = 0; start <= equals; start = end + 1) {
        end = std::min(assignment.find('.', start), equals);
        const std::string step = assignment.substr(start, end - start);
        value = step.empty() ? nullptr : step_into(*value, step);
        if (!value) {
            const std::string stop = pointer.empty() ? "the scene" : pointer;
            throw SceneError(printable(fmt::format("{}: cannot set {}: {} has no \"{}\"", document.file, assignment, stop, step)));
        }
        pointer += "/" + pointer_step(step);
    }
    const std::string text = assignment.substr(equals + 1);
    json parsed = json::parse(text, nullptr, false);
    *value = parsed.is_discarded() ? json(text) : std::move(parsed);
    document.assigned.insert(pointer);
}

std::string pointer_step(const std::string &key) {
    std::string result;
    for (const char c : key) c == '~' ? result += "~0" : c == '/' ? result += "~1" : result += c;
    return result;
}

std::string place_of(const Document &document, const std::string &pointer) {
    std::optional<std::size_t> line = line_of(document, pointer);
    const auto covers = [&](const std::string &assigned) {
        return is_at_or_below(pointer, assigned) || (!line && is_at_or_below(assigned, pointer));  // an object made on the way to what was set
    };
    if (std::any_of(document.assigned.begin(), document.assigned.end(), covers)) return document.file + ": " + pointer + " (set on the command line)";
    for (std::string ancestor = pointer; !line && !ancestor.empty();) {
        ancestor.resize(ancestor.rfind('/'));
        line = line_of(document, ancestor);
    }
    return document.file + ":" + std::to_string(line.value_or(1)) + (pointer.empty() ? "" : ": " + pointer);
}

void fail_at(const Document &document, const std::string &pointer, const std::string &why) {
    throw SceneError(printable(place_of(document, pointer) + ": " + why));
}

}  // namespace brandung
