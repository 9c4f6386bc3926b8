/// Numbers that options take.
#pragma once
#include <CLI/CLI.hpp>

#include <string>

namespace brandung {

/// Those for which `allowed` says so, which it must not of NaN; `what` says which these are: "must be ...".
inline CLI::Validator numbers(bool (*allowed)(double), const std::string &what, const std::string &unit) {
    const auto fault = [=](const std::string &text) {
        double number = 0;
        const bool is_number = CLI::detail::lexical_cast(text, number);
        return is_number && allowed(number) ? std::string() : "must be " + what + ", got '" + text + "'";
    };
    return {fault, unit};
}

}  // namespace brandung
