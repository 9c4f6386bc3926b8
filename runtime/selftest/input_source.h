/// InputSource: random numbers of many kinds, the same on every machine.
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>

#include "kernels/core/portable.h"

namespace brandung {

class InputSource {
public:
    explicit InputSource(std::uint64_t seed) : state_(seed) {}

    /// SplitMix64 (Steele, Lea, Flood, OOPSLA 2014).
    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    uint below(uint end) { return static_cast<uint>((bits() >> 32) * end >> 32); }
    bool one_in(uint n) { return below(n) == 0; }
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    float uniform(double low, double high) { return static_cast<float>(low + (high - low) * unit()); }
    /// A power of two, of any real exponent between these.
    float power_of_two(double low, double high) { return static_cast<float>(std::exp2(low + (high - low) * unit())); }
    /// Part of a length by which an aim is beside what decides: often none, and else of any magnitude, so that what rounding may turn is surrounded.
    float beside() { return one_in(4) ? 0.0f : sign() * power_of_two(-22, -2); }
    float sign() { return one_in(2) ? -1.0f : 1.0f; }
    /// Any bits: NaN and infinity too.
    float any_float() { return std::bit_cast<float>(static_cast<std::uint32_t>(bits() >> 32)); }
    float subnormal() { return std::bit_cast<float>(static_cast<std::uint32_t>(bits() >> 41) | (one_in(2) ? 0x80000000u : 0u)); }
    vec3 in_cube(float half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
    /// Unit length to rounding, uniform on the sphere.
    vec3 direction() {
        for (;;) {
            const glm::dvec3 v(2 * unit() - 1, 2 * unit() - 1, 2 * unit() - 1);
            const double square = glm::dot(v, v);
            if (square > 1e-4 && square <= 1) return vec3(v / std::sqrt(square));
        }
    }

private:
    std::uint64_t state_;
};

/// Seeds for the parts of a round, no two the same.
inline std::uint64_t seed_of(std::uint64_t subject, std::uint64_t round, std::uint64_t part) {
    return InputSource(InputSource(InputSource(subject).bits() ^ round).bits() ^ part).bits();
}

}  // namespace brandung
