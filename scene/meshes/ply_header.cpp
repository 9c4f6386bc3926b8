#include "scene/meshes/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>

#include "scene/error.h"
#include "scene/formats/tokens.h"

namespace brandung {
namespace {

struct TypeName {
    std::string_view name, old_name;
    uint bytes;
};
/// By PlyType.
constexpr TypeName type_names[] = {{"int8", "char", 1}, {"uint8", "uchar", 1}, {"int16", "short", 2},   {"uint16", "ushort", 2},
                                   {"int32", "int", 4}, {"uint32", "uint", 4}, {"float32", "float", 4}, {"float64", "double", 8}};

class HeaderReader {
public:
    HeaderReader(const std::string &file, const std::string &text) : file_(file), text_(text) {
        // The first line tells whether lines end with a carriage return alone: behind the last one, a line feed may be data.
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        if (text.substr(end, 1) == "\r" && text.substr(end, 2) != "\r\n") line_end_ = '\r';
    }

    PlyHeader read() {
        next_line();
        if (words_.size() != 1 || words_[0] != "ply") fail("not a PLY file: it does not begin with the line \"ply\"");
        next_line();
        read_format();
        while (next_line(), words_.empty() || words_[0] != "end_header") read_statement();
        header_.bytes = at_;
        return std::move(header_);
    }

private:
    [[noreturn]] void fail(const std::string &why) const { throw SceneError(fmt::format("{}:{}: {}", file_, std::max(header_.lines, 1u), why)); }

    void next_line() {
        const std::size_t end = text_.find(line_end_, at_);
        ++header_.lines;
        if (end == std::string::npos) fail("the header has no end: \"end_header\" is missing");
        line_ = std::string_view(text_).substr(at_, end - at_);
        at_ = end + 1;
        words_.clear();
        constexpr std::string_view blanks = " \t\r\v\f";
        for (std::size_t begin = line_.find_first_not_of(blanks); begin != std::string_view::npos;) {
            const std::size_t stop = std::min(line_.find_first_of(blanks, begin), line_.size());
            words_.push_back(line_.substr(begin, stop - begin));
            begin = line_.find_first_not_of(blanks, stop);
        }
    }

    void read_format() {
        constexpr std::string_view names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
        if (words_.size() != 3 || words_[0] != "format") fail("expected the format, as \"format ascii 1.0\"");
        const auto name = std::find(std::begin(names), std::end(names), words_[1]);
        if (name == std::end(names)) fail("unknown format " + quoted(words_[1]) + "; known: ascii, binary_little_endian, binary_big_endian");
        if (words_[2] != "1.0") fail("unknown version " + quoted(words_[2]) + "; known: 1.0");
        header_.format = PlyFormat(name - std::begin(names));
    }

    void read_statement() {
        if (words_.empty() || words_[0] == "obj_info") return;
        if (words_[0] == "comment")
            header_.comments.emplace_back(line_);
        else if (words_[0] == "element")
            read_element();
        else if (words_[0] == "property")
            read_property();
        else
            fail("expected one of comment, element, property, end_header, found " + quoted(words_[0]));
    }

    void read_element() {
        PlyElement element;
        if (words_.size() != 3) fail("expected \"element NAME COUNT\"");
        const auto [stop, error] = std::from_chars(words_[2].data(), words_[2].data() + words_[2].size(), element.count);
        if (error != std::errc() || stop != words_[2].data() + words_[2].size()) fail("element: expected a count, found " + quoted(words_[2]));
        element.name = words_[1];
        for (const PlyElement &other : header_.elements)
            if (other.name == element.name) fail("second element " + brandung::quoted(element.name));
        header_.elements.push_back(std::move(element));
    }

    PlyType type(std::string_view word) const {
        const auto named = [&](const TypeName &t) { return t.name == word || t.old_name == word; };
        const auto found = std::find_if(std::begin(type_names), std::end(type_names), named);
        if (found == std::end(type_names)) fail("unknown type " + quoted(word));
        return PlyType(found - std::begin(type_names));
    }

    void read_property() {
        if (header_.elements.empty()) fail("property before any element");
        const bool list = words_.size() == 5 && words_[1] == "list";
        if (!list && words_.size() != 3) fail("expected \"property TYPE NAME\" or \"property list TYPE TYPE NAME\"");
        PlyProperty property{.name = std::string(words_.back()), .type = type(words_[list ? 3 : 1]), .count = {}};
        if (list) property.count = type(words_[2]);
        if (list && is_float(*property.count)) fail("the length of a list cannot be of type " + quoted(words_[2]));
        for (const PlyProperty &other : header_.elements.back().properties)
            if (other.name == property.name) fail("second property " + quoted(property.name));
        header_.elements.back().properties.push_back(std::move(property));
    }

    const std::string &file_, &text_;
    PlyHeader header_;
    char line_end_ = '\n';
    std::size_t at_ = 0;
    std::string_view line_;
    std::vector<std::string_view> words_;
};

}  // namespace

uint bytes_of(PlyType type) { return type_names[int(type)].bytes; }
bool is_signed(PlyType type) { return type == PlyType::int8 || type == PlyType::int16 || type == PlyType::int32; }
bool is_float(PlyType type) { return type == PlyType::float32 || type == PlyType::float64; }

PlyHeader read_ply_header(const std::string &file, const std::string &text) { return HeaderReader(file, text).read(); }

}  // namespace brandung
