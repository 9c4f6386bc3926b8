/// Random choices that are the same on every machine.
#pragma once
#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "kernels/core/portable.h"

namespace brandung {

/// The generator splitmix64 (Steele, Lea & Flood 2014), which needs integers only. Numbers are dyadic fractions, and made without functions whose
/// rounding libraries choose.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}

    uint below(uint end) { return static_cast<uint>((next() >> 32) * end >> 32); }
    bool chance(uint percent) { return below(100) < percent; }
    /// In steps of 2^-16 of the whole.
    double uniform(double low, double high) { return low + (high - low) * std::ldexp(static_cast<double>(next() >> 48), -16); }
    /// 2 to a power from low to high.
    double power(int low, int high) { return std::ldexp(1.0, low + static_cast<int>(below(static_cast<uint>(high - low + 1)))); }
    template <class T> T pick(std::initializer_list<T> choices) { return choices.begin()[below(static_cast<uint>(choices.size()))]; }

private:
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
        z = (z ^ z >> 27) * 0x94d049bb133111ebu;
        return z ^ z >> 31;
    }
    std::uint64_t state_;
};

}  // namespace brandung
