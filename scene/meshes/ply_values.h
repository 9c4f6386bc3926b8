/// The values of PLY files, from text or from bytes: two classes with the same functions.
#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "scene/formats/tokens.h"
#include "scene/meshes/ply_header.h"

namespace brandung {

class PlyText {
public:
    /// The values that follow the header in the text.
    PlyText(const std::string &file, std::string text, const PlyHeader &header) : tokens_(file, std::move(text), header.bytes, header.lines + 1) {}

    /// NaN for what is no number or beyond 1e15. Throws SceneError if there is none.
    double value(PlyType type, const char *what) { return is_float(type) ? double(tokens_.any_length(what)) : double(tokens_.integer(what)); }
    /// At least so many bytes are left for every value.
    static std::size_t smallest(PlyType) { return 2; }
    /// Bytes that are left, with one for the blank that the last value need not have.
    std::size_t left() const { return tokens_.left() + 1; }
    double part() const { return tokens_.part(); }
    /// Whether something follows that is no blank.
    bool has_more() { return !tokens_.at_end(); }
    /// Throws SceneError `file:line: why`.
    [[noreturn]] void fail(const std::string &why) const { tokens_.fail(why); }

private:
    Tokens tokens_;
};

class PlyBytes {
public:
    PlyBytes(const std::string &file, std::string text, const PlyHeader &header)
        : file_(file),
          text_(std::move(text)),
          at_(text_.data() + header.bytes),
          end_(text_.data() + text_.size()),
          swap_((header.format == PlyFormat::big_endian) != (std::endian::native == std::endian::big)) {}
    PlyBytes(const PlyBytes &) = delete;

    double value(PlyType type, const char *what) {
        switch (type) {
            case PlyType::int8:
                return read<std::int8_t>(what);
            case PlyType::uint8:
                return read<std::uint8_t>(what);
            case PlyType::int16:
                return read<std::int16_t>(what);
            case PlyType::uint16:
                return read<std::uint16_t>(what);
            case PlyType::int32:
                return read<std::int32_t>(what);
            case PlyType::uint32:
                return read<std::uint32_t>(what);
            case PlyType::float32:
                return usable(read<float>(what));
            case PlyType::float64:
                return usable(read<double>(what));
        }
        return 0;
    }
    static std::size_t smallest(PlyType type) { return bytes_of(type); }
    std::size_t left() const { return std::size_t(end_ - at_); }
    double part() const { return double(at_ - text_.data()) / double(text_.size()); }
    bool has_more() const {
        return std::any_of(at_, end_, [](char c) { return c != ' ' && c != '\n' && c != '\r'; });
    }
    [[noreturn]] void fail(const std::string &why) const;

private:
    static double usable(double value) { return std::abs(value) <= 1e15 ? value : std::numeric_limits<double>::quiet_NaN(); }

    template <class T> T read(const char *what) {
        if (left() < sizeof(T)) fail(std::string(what) + ": the file ends before it");
        char bytes[sizeof(T)];
        for (std::size_t i = 0; i < sizeof(T); ++i) bytes[i] = at_[swap_ ? sizeof(T) - 1 - i : i];
        at_ += sizeof(T);
        T value;
        std::memcpy(&value, bytes, sizeof(T));
        return value;
    }

    std::string file_, text_;
    const char *at_, *end_;
    bool swap_;
};

}  // namespace brandung
