/// Findings: what the self-test has seen of one subject.
#pragma once
#include <array>
#include <cstdint>
#include <string>

namespace brandung {

/// What errors are measured of. Positions: distances from the true surface; normals: between unit vectors, in ulp of 1;
/// shading: those of interpolated normals; uv: of coordinates on the surface; offsets: of the beginnings of rays from where they should begin.
enum class Quantity { value, t, position, normal, shading, uv, offset };
inline constexpr std::size_t quantities = 7;
inline constexpr std::array<const char *, quantities> quantity_names = {"value", "t", "position", "normal", "shading", "uv", "offset"};

/// Errors of one quantity.
struct Errors {
    std::uint64_t count = 0, beyond = 0;  ///< how many, and how many of them are larger than their bounds
    std::uint64_t unknown = 0;            ///< how many more were not looked at, since rounding may make anything of them
    double max_of_bound = 0;              ///< error over the bound that holds there
    // Of those only whose bound is less than 2^-12 of the quantity: others say nothing but how ill the inputs are conditioned.
    std::uint64_t well_conditioned = 0;
    double max_ulps = 0, sum_ulps = 0;
    double max_relative = 0, sum_relative = 0;

    void add(double error, double allowed, double ulp, double magnitude);
    void add(const Errors &more);
};

struct Findings {
    std::uint64_t inputs = 0;
    std::uint64_t hits = 0;                   ///< inputs that meet something, or otherwise test more than that nothing happens
    std::uint64_t ambiguous = 0;              ///< decisions that rounding may turn, as the oracle certifies; either is right
    std::uint64_t wrong = 0;                  ///< other decisions that are not the oracle's
    std::array<Errors, quantities> errors;    ///< against extended precision
    std::array<Errors, quantities> rounding;  ///< against the same source in double
    std::string fault;                        ///< the first thing that is not as it should be, in words; empty: none

    Errors &of(Quantity quantity) { return errors[static_cast<std::size_t>(quantity)]; }
    Errors &rounding_of(Quantity quantity) { return rounding[static_cast<std::size_t>(quantity)]; }
    /// A wrong decision.
    template <class Describe> void blame(Describe describe) {
        ++wrong;
        if (fault.empty()) fault = describe();
    }
    /// An error against what is allowed, all in the quantity's unit. `describe` is called if it is the first that is larger.
    template <class Describe> void measure(Quantity quantity, double error, double allowed, double ulp, double magnitude, Describe describe) {
        of(quantity).add(error, allowed, ulp, magnitude);
        if (!(error <= allowed) && fault.empty()) fault = describe();
    }
    /// An error for which there is no bound of use.
    void leave_out(Quantity quantity) { ++of(quantity).unknown; }

    bool passed() const;
    void add(const Findings &more);
};

}  // namespace brandung
