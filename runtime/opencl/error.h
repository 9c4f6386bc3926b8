/// What went wrong on a device.
#pragma once
#include <stdexcept>
#include <string>

namespace brandung {

/// One line: what was attempted, with which thing, why it failed.
class Error : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A kernel did not compile; `log` is the compiler's, with the real files' names and lines.
class BuildError : public Error {
public:
    BuildError(const std::string &what, std::string log) : Error(what), log(std::move(log)) {}
    std::string log;
};

/// "CL_OUT_OF_RESOURCES" for -5; the number itself where it has no name.
std::string status_name(int status);

}  // namespace brandung
