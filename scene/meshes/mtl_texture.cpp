#include "scene/meshes/mtl_texture.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>

#include "scene/parameters.h"

namespace brandung {
namespace {

constexpr std::string_view blanks = " \t";

std::string_view without_blanks(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
    return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

/// Takes the first word, and the blanks around it, off a line that begins with none.
std::string_view take_word(std::string_view &line) {
    const std::string_view word = line.substr(0, line.find_first_of(blanks));
    line = without_blanks(line.substr(word.size()));
    return word;
}

/// Takes a number off a line that begins with one.
std::optional<float> take_number(std::string_view &line) {
    std::string_view rest = line;
    const std::string_view word = take_word(rest);
    float value;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || stop != word.data() + word.size() || !(std::abs(value) <= max_magnitude)) return {};
    line = rest;
    return value;
}

/// Up to three numbers, of which two are used; for the others `value` is left.
void take_numbers(std::string_view &line, vec2 &value) {
    for (int i = 0; i < 3; ++i) {
        const std::optional<float> number = take_number(line);
        if (!number) return;
        if (i < 2) value[i] = *number;
    }
}

/// Takes what follows an option off the line; false if it is not used though it matters for how a picture looks.
using ReadOption = bool (*)(std::string_view &line, MtlTexture &texture);

bool read_scale(std::string_view &line, MtlTexture &texture) { return take_numbers(line, texture.scale), true; }
bool read_offset(std::string_view &line, MtlTexture &texture) { return take_numbers(line, texture.offset), true; }
bool read_clamp(std::string_view &line, MtlTexture &texture) { return texture.clamps = take_word(line) == "on", true; }

bool read_colorspace(std::string_view &line, MtlTexture &texture) {
    const std::string_view space = take_word(line);
    texture.encoding = space == "sRGB" ? Encoding::srgb : space == "linear" ? Encoding::linear : Encoding::automatic;
    return texture.encoding != Encoding::automatic;
}

bool skip_word(std::string_view &line, MtlTexture &) { return take_word(line), true; }
bool leave_word(std::string_view &line, MtlTexture &) { return take_word(line), false; }
bool leave_numbers(std::string_view &line, MtlTexture &) {
    vec2 numbers;
    return take_numbers(line, numbers), false;
}

struct Option {
    std::string_view name;
    ReadOption read;
};
constexpr Option options[] = {{"-s", read_scale},     {"-o", read_offset},     {"-clamp", read_clamp}, {"-colorspace", read_colorspace},
                              {"-blendu", skip_word}, {"-blendv", skip_word},  {"-boost", skip_word},  {"-texres", skip_word},
                              {"-bm", skip_word},     {"-mm", leave_numbers},  {"-t", leave_numbers},  {"-cc", leave_word},
                              {"-type", leave_word},  {"-imfchan", leave_word}};

const Option *option_at(std::string_view line) {
    const std::string_view word = take_word(line);
    const auto found = std::find_if(std::begin(options), std::end(options), [&](const Option &option) { return option.name == word; });
    return found == std::end(options) ? nullptr : found;
}

/// Takes all options off a line that begins with them.
void take_options(std::string_view &line, MtlTexture &texture, std::map<std::string, uint> &warnings) {
    while (const Option *option = option_at(line)) {
        take_word(line);
        if (!option->read(line, texture)) ++warnings["option of a texture (" + std::string(option->name) + "): not used"];
    }
}

/// Where the first option behind a name begins.
std::size_t name_end(std::string_view line) {
    std::size_t end = line.size();
    for (const Option &option : options) end = std::min(end, line.find(" " + std::string(option.name) + " "));
    return end;
}

}  // namespace

MtlTexture read_mtl_texture(std::string_view line, std::map<std::string, uint> &warnings) {
    MtlTexture texture;
    line = without_blanks(line);
    take_options(line, texture, warnings);
    const std::size_t end = name_end(line);
    texture.file = without_blanks(line.substr(0, end));
    line = without_blanks(line.substr(end));
    take_options(line, texture, warnings);
    return texture;
}

}  // namespace brandung
