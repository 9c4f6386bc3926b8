#include "runtime/opencl/source.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <unordered_map>

#include "runtime/opencl/embedded_kernels.h"
#include "runtime/opencl/error.h"

namespace brandung {
namespace {

/// The file in the folder that KERNEL_DIR names.
std::ifstream open_in(const char *directory, const std::string &path) {
    return std::ifstream(std::filesystem::path(directory) / std::filesystem::path(path).lexically_relative("kernels"));
}

std::string read_kernel(const std::string &path, const Sources &generated) {
    if (const auto file = generated.find(path); file != generated.end()) return file->second;
    if (const char *directory = std::getenv("KERNEL_DIR")) {
        std::ifstream in = open_in(directory, path);
        if (in) return {std::istreambuf_iterator<char>(in), {}};
        throw Error("no such kernel source: " + path + " in KERNEL_DIR=" + directory);
    }
    for (const EmbeddedFile &file : embedded_kernels())
        if (file.path == path) return std::string(file.text);
    throw Error("no such kernel source: " + path);
}

constexpr std::string_view include_mark = "#include \"", define_mark = "#define ";

void expand(const std::string &path, const Sources &generated, std::set<std::string> &seen, std::string &out) {
    const std::string text = read_kernel(path, generated);
    if (text.find("#pragma once") != std::string::npos && !seen.insert(path).second) return;
    out += "#line 1 \"" + path + "\"\n";
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        if (line.starts_with(include_mark)) {
            const auto end = line.find('"', include_mark.size());
            expand(line.substr(include_mark.size(), end - include_mark.size()), generated, seen, out);
            out += "#line " + std::to_string(number + 1) + " \"" + path + "\"\n";
        } else if (line.starts_with("#pragma once")) {
            out += "\n";
        } else {
            out += line + "\n";
        }
    }
}

bool is_of_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// The first name from `begin` on; empty at the end.
std::string_view name_in(std::string_view text, std::size_t begin) {
    const auto first = std::find_if(text.begin() + static_cast<std::ptrdiff_t>(begin), text.end(), is_of_name);
    return {first, std::find_if_not(first, text.end(), is_of_name)};
}

using Uses = std::unordered_map<std::string_view, std::size_t>;

Uses uses_of_names(std::string_view text) {
    Uses uses;
    for (std::string_view name = name_in(text, 0); !name.empty();) {
        ++uses[name];
        name = name_in(text, static_cast<std::size_t>(name.data() + name.size() - text.data()));
    }
    return uses;
}

/// The text, where lines of generated files are empty that define a name which nothing uses.
std::string without_unused_definitions(const std::string &text) {
    const Uses uses = uses_of_names(text);
    bool is_generated = false;
    std::string out;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line); out += "\n") {
        if (line.starts_with("#line ")) is_generated = line.find("\"generated/") != std::string::npos;
        if (!(is_generated && line.starts_with(define_mark) && uses.at(name_in(line, define_mark.size())) == 1)) out += line;
    }
    return out;
}

}  // namespace

std::string expand_source(const std::string &path, const Sources &generated) {
    std::set<std::string> seen;
    std::string out;
    expand(path, generated, seen, out);
    return without_unused_definitions(out);
}

std::uint64_t hash_of_text(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash;
}

std::uint64_t hash_of_kernels() {
    std::string all;
    for (const EmbeddedFile &file : embedded_kernels()) {
        if (const char *directory = std::getenv("KERNEL_DIR")) {
            std::ifstream in = open_in(directory, std::string(file.path));
            all.append(std::istreambuf_iterator<char>(in), {});
        } else {
            all += file.text;
        }
        all += '\0';
    }
    return hash_of_text(all);
}

}  // namespace brandung
