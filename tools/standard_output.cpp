#include "tools/standard_output.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "scene/error.h"

namespace brandung {

void print_result(const std::string &text) {
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (std::fflush(stdout) != 0 || !written) throw SceneError(std::string("standard output: cannot write there: ") + std::strerror(errno));
}

}  // namespace brandung
