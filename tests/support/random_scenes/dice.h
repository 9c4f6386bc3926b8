/// Random choices that are the same on every machine.
#pragma once
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "runtime/selftest/input_source.h"

namespace brandung {

/// Of integers. Numbers are dyadic fractions, and made without functions whose rounding libraries choose.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : source_(seed) {}

    uint below(uint end) { return source_.below(end); }
    bool chance(uint percent) { return below(100) < percent; }
    /// In steps of 2^-16 of the whole.
    double uniform(double low, double high) { return low + (high - low) * std::ldexp(static_cast<double>(source_.bits() >> 48), -16); }
    /// 2 to a power from low to high.
    double power(int low, int high) { return std::ldexp(1.0, low + static_cast<int>(below(static_cast<uint>(high - low + 1)))); }
    template <class T> T pick(std::initializer_list<T> choices) { return choices.begin()[below(static_cast<uint>(choices.size()))]; }

private:
    InputSource source_;
};

}  // namespace brandung
