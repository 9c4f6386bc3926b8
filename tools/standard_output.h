/// Results on standard output.
#pragma once
#include <string>

namespace brandung {

/// Throws SceneError if not all of it could be written.
void print_result(const std::string &text);

}  // namespace brandung
