#include "tools/distinct_files.h"

#include <CLI/CLI.hpp>

#include "scene/output.h"

namespace brandung {
namespace {

/// One name per file, however it is spelt; the spelling itself where the system does not tell.
std::filesystem::path canonical_name(const std::string &file) {
    std::error_code error;
    const std::filesystem::path absolute = std::filesystem::absolute(linked_file(file), error);
    const std::filesystem::path canonical = error ? absolute : std::filesystem::weakly_canonical(absolute, error);
    return error ? std::filesystem::path(file) : canonical;
}

}  // namespace

DistinctFiles::DistinctFiles(const std::vector<std::string> &inputs) {
    for (const std::string &input : inputs) known_.emplace(canonical_name(input), Known{input, "what is read"});
}

void DistinctFiles::add_output(const std::string &option, const std::string &file) {
    const auto [entry, added] = known_.emplace(canonical_name(file), Known{file, "what " + option + " writes"});
    if (added) return;
    const Known &known = entry->second;
    throw CLI::ValidationError(option, "'" + file + "' would overwrite " + known.role + (file == known.name ? "" : ", '" + known.name + "'"));
}

}  // namespace brandung
