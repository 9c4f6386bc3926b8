/// Numbers that options take.
#pragma once
#include <CLI/CLI.hpp>

#include <charconv>
#include <cstdint>
#include <string>

#include "kernels/core/portable.h"

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

/// Whole ones from `low` to `high`, in decimal digits.
inline CLI::Validator whole_numbers(uint low, uint high) {
    const auto fault = [=](const std::string &text) {
        std::uint64_t number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        const bool octal = text.size() > 1 && text[0] == '0';  // to CLI11, which converts it
        const bool whole = error == std::errc() && end == text.data() + text.size() && !octal && number >= low && number <= high;
        return whole ? "" : "must be a whole number from " + std::to_string(low) + " to " + std::to_string(high) + ", got '" + text + "'";
    };
    return {fault, "NUMBER"};
}

}  // namespace brandung
