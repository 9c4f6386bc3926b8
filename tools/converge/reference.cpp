#include "tools/converge/reference.h"

#include <fmt/format.h>

#include <charconv>

#include "scene/error.h"
#include "tools/provenance.h"

namespace brandung {
namespace {

constexpr std::string_view prefix = "brandung:", separator = ", ";

/// All of a text as a number; nothing of anything else.
template <class Number> std::optional<Number> number_in(const std::map<std::string, std::string> &metadata, const char *name) {
    const auto found = metadata.find(std::string(prefix) + name);
    if (found == metadata.end()) return {};
    const char *const end = found->second.data() + found->second.size();
    Number number;
    const auto [stop, error] = std::from_chars(found->second.data(), end, number);
    return error == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

std::map<std::string, std::string> biases_in(const std::string &names) {
    std::map<std::string, std::string> biases;
    for (std::size_t begin = 0, end = 0; begin < names.size(); begin = end + separator.size()) {
        end = std::min(names.find(separator, begin), names.size());
        biases.emplace(names.substr(begin, end - begin), "");
    }
    return biases;
}

}  // namespace

ReferencePicture read_reference(const std::string &file) {
    ReferencePicture reference{read_picture(file), file};
    const auto &metadata = reference.picture.metadata;
    reference.noise = number_in<double>(metadata, "noise");
    reference.seed = number_in<uint>(metadata, "seed");
    if (!metadata.contains("brandung:scene_hash")) return reference;
    Way &way = reference.way.emplace(Way{file, {}, {}});
    for (const auto &[name, value] : metadata)
        if (name.starts_with(prefix)) way.settings[name.substr(prefix.size())] = value;
    if (const auto biases = metadata.find("brandung:biased_by"); biases != metadata.end()) way.biased_by = biases_in(biases->second);
    return reference;
}

void write_reference(const std::string &file, const ReferencePicture &reference) {
    Picture picture = reference.picture;
    picture.metadata = {{"Software", program_version()}, {"brandung:reference", reference.name}};
    for (const auto &[name, value] : reference.way.value().settings) picture.metadata[std::string(prefix) + name] = value;
    picture.metadata["brandung:seed"] = std::to_string(reference.seed.value());
    if (reference.noise) picture.metadata["brandung:noise"] = fmt::format("{:.6g}", *reference.noise);
    std::vector<std::string> biases;
    for (const auto &[name, why] : reference.way->biased_by) biases.push_back(name);
    picture.metadata["brandung:biased_by"] = fmt::format("{}", fmt::join(biases, separator));
    write_picture(file, picture);
}

void check_reference_writable(const std::string &file, uint width, uint height) {
    check_picture_writable(file, width, height);
    if (!file.ends_with(".exr")) throw SceneError(file + ": must be an EXR, which keeps floats and what the reference was made from");
}

}  // namespace brandung
