#include "runtime/opencl/source.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

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

constexpr std::string_view include_mark = "#include \"";

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

}  // namespace

std::string expand_source(const std::string &path, const Sources &generated) {
    std::set<std::string> seen;
    std::string out;
    expand(path, generated, seen, out);
    return out;
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
