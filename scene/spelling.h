/// Names that may be others misspelt.
#pragma once
#include <string>
#include <vector>

namespace brandung {

/// Whether one may be the other misspelt: few letters differ, and fewer in short names.
bool resembles(const std::string &word, const std::string &name);

/// Those that are most like `word` first.
std::vector<std::string> by_likeness(const std::string &word, std::vector<std::string> names);

}  // namespace brandung
