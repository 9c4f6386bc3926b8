/// The statements of material libraries.
#include "scene/meshes/mtl.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "scene/formats/tokens.h"
#include "scene/warnings.h"

namespace brandung {
namespace {

struct Reading {
    Tokens tokens;
    Scene &scene;
    std::vector<MtlMaterial> materials;

    MtlMaterial &material() { return materials.back(); }
    void warn(const std::string &text) { ++scene.warnings[text]; }
};

/// One value for all three parts, or three.
void read_color(Reading &reading, std::optional<Spectrum> &color) {
    Tokens &tokens = reading.tokens;
    if (!tokens.at_number_on_line()) {  // "spectral FILE" and "xyz X Y Z"
        reading.warn("material with a colour that is not three numbers: not used");
        return tokens.skip_line();
    }
    Spectrum value(tokens.not_negative("colour of a material"));
    for (int i = 1; i < 3 && tokens.at_number_on_line(); ++i) value[i] = value[2] = tokens.not_negative("colour of a material");
    color = value;
}

void read_number(Reading &reading, std::optional<float> &number) {
    Tokens &tokens = reading.tokens;
    if (!tokens.at_line_end() && tokens.peek() == "-halo") tokens.word();
    if (!tokens.at_number_on_line()) tokens.fail("value of a material: expected a number on the line");
    number = tokens.length("value of a material");
}

void read_illum(Reading &reading) {
    if (!reading.tokens.at_number_on_line()) reading.tokens.fail("illum: expected a whole number on the line");
    const int64 illum = reading.tokens.integer("illum");
    if (illum < 0 || illum > 10) reading.tokens.fail("illum: must be from 0 to 10, got " + std::to_string(illum));
    reading.material().illum = illum;
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

/// Of statements that Whitted's surface has nothing for; false if this is none of them.
bool is_left_out(const std::string &key) {
    return key.starts_with("map_") || is_one_of(key, {"bump", "disp", "decal", "refl", "norm", "ps", "pc", "pcr", "aniso", "anisor", "sharpness"});
}

void read_statement(Reading &reading, const std::string &key) {
    Tokens &tokens = reading.tokens;
    MtlMaterial &material = reading.material();
    if (key == "kd") return read_color(reading, material.kd);
    if (key == "ks") return read_color(reading, material.ks);
    if (key == "ke") return read_color(reading, material.ke);
    if (key == "tf" || key == "kt") return read_color(reading, material.tf);
    if (key == "ns") return read_number(reading, material.ns);
    if (key == "ni") return read_number(reading, material.ni);
    if (key == "d") return read_number(reading, material.d);
    if (key == "tr") return read_number(reading, material.tr);
    if (key == "pr") return read_number(reading, material.roughness);
    if (key == "pm") return read_number(reading, material.metallic);
    if (key == "illum") return read_illum(reading);
    if (key == "map_kd") return void(material.map_kd = read_mtl_texture(tokens.rest_of_line(), reading.scene.warnings));
    if (key == "map_ks") return void(material.map_ks = read_mtl_texture(tokens.rest_of_line(), reading.scene.warnings));
    tokens.skip_line();
    if (is_one_of(key, {"ka", "map_ka"})) return;
    if (is_left_out(key))
        reading.warn("material statement that Whitted's surface has nothing for (" + key + "): not used");
    else
        reading.warn("unknown material statement: not used");
}

}  // namespace

std::vector<MtlMaterial> read_mtl(const std::string &file, Scene &scene) {
    Reading reading{Tokens(file), scene, {}};
    Tokens &tokens = reading.tokens;
    while (!tokens.at_end()) {
        std::string key(tokens.word());
        const uint line = tokens.line();
        std::transform(key.begin(), key.end(), key.begin(), [](unsigned char c) { return std::tolower(c); });
        if (key == "newmtl") {
            MtlMaterial &material = reading.materials.emplace_back();
            material.name = tokens.rest_of_line();
            material.file = file, material.line = line;
        } else if (reading.materials.empty()) {
            reading.warn("material statement before any newmtl: not used");
            tokens.skip_line();
        } else {
            read_statement(reading, key);
        }
        if (!tokens.at_line_end()) {
            reading.warn("material statement with more on its line than it takes: the rest is not used");
            tokens.skip_line();
        }
        place_warnings(scene, [&] { return fmt::format("{}:{}", file, line); });
    }
    return std::move(reading.materials);
}

}  // namespace brandung
