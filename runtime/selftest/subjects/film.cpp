/// The film's arithmetic, which is exact: against the host's integers of 128 bits.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernels/core/items.h"
#include "runtime/opencl/kernel.h"
#include "runtime/selftest/examine.h"
#include "runtime/selftest/input_source.h"
#include "runtime/selftest/subjects/list.h"

namespace brandung {
namespace {

constexpr std::size_t inputs_per_round = 1 << 18;

using wide_int = __int128;
using wide_uint = unsigned __int128;

/// As kernels/selftest/film.cl has it.
struct FilmResult {
    Integer128 sum, added;
    int64 nearest, fixed;
    float rounded;
    uint equal;
};

wide_int wide(Integer128 x) { return static_cast<wide_int>(static_cast<wide_uint>(x.high) << 64 | x.low); }
wide_int wrapped_sum(wide_int a, wide_int b) { return static_cast<wide_int>(static_cast<wide_uint>(a) + static_cast<wide_uint>(b)); }
std::string text_of(Integer128 x) { return fmt::format("{:#x}:{:016x}", x.high, x.low); }

/// Of any magnitude, and near where carries and signs turn.
Integer128 any_integer(InputSource &source) {
    const wide_int bits = static_cast<wide_int>(static_cast<wide_uint>(source.bits()) << 64 | source.bits()) >> source.below(128);
    const wide_int value = source.one_in(4) ? (wide_int{source.one_in(2) ? 1 : -1} << source.below(127)) + wide_int(source.below(5)) - 2 : bits;
    return {static_cast<std::uint64_t>(value), static_cast<std::uint64_t>(static_cast<wide_uint>(value) >> 64)};
}

/// Contributions as they are, halves of the unit, and beyond the cut.
float any_contribution(InputSource &source) {
    if (source.one_in(3)) return source.sign() * (float(source.below(1 << 22)) + 0.5f) * 0x1p-32f;
    return source.sign() * (source.one_in(8) ? source.power_of_two(16, 127) : source.power_of_two(-40, 18));
}

class FilmArithmetic final : public Subject {
public:
    explicit FilmArithmetic(Device &device)
        : device_(device),
          kernel_(device, "kernels/selftest/film.cl", "test_film", {{"generated/constants.h", "#pragma once\n#define BRANCHING 2u\n"}}) {}

    Findings examine(uint round) override {
        std::vector<Integer128> a(inputs_per_round), b(inputs_per_round);
        std::vector<float> x(inputs_per_round);
        InputSource source(seed_of(7, round, 0));
        for (std::size_t i = 0; i < inputs_per_round; ++i) a[i] = any_integer(source), b[i] = any_integer(source), x[i] = any_contribution(source);
        Buffer<FilmResult> results(device_, inputs_per_round);
        kernel_(inputs_per_round, Buffer<Integer128>(device_, a), Buffer<Integer128>(device_, b), Buffer<float>(device_, x),
                static_cast<uint>(inputs_per_round), results);
        const std::vector<FilmResult> read = results.read();
        device_.finish();
        return examine_each(inputs_per_round, [&](std::size_t i, Findings &findings) { look_at(a[i], b[i], x[i], read[i], findings); });
    }

private:
    static void look_at(Integer128 a, Integer128 b, float x, const FilmResult &result, Findings &findings) {
        const auto expect = [&](bool right, const char *what) {
            if (!right) findings.blame([&] { return fmt::format("{} of {}, {}, {:a}", what, text_of(a), text_of(b), x); });
        };
        constexpr wide_int limit = wide_int{1} << 48;
        const wide_int value = wide(a), low = static_cast<std::int64_t>(b.low);
        const long double scaled = std::clamp(static_cast<long double>(x), -0x1p17L, 0x1p17L) * 0x1p32L;
        ++findings.hits;
        expect(wide(result.sum) == wrapped_sum(value, wide(b)), "plus");
        expect(wide(result.added) == wrapped_sum(value, low), "add");
        expect(result.nearest == std::clamp(value, -limit, limit), "nearest_within");
        expect(result.fixed == std::llrint(scaled), "fixed_point");
        expect((result.equal != 0) == (value == static_cast<std::int64_t>(a.low)), "equal");
        const double exact = std::abs(static_cast<double>(value)), error = std::abs(static_cast<double>(result.rounded) - static_cast<double>(value));
        findings.measure(Quantity::value, error, 0x1.0001p-23 * exact, exact == 0 ? 1 : std::ldexp(1.0, std::ilogb(exact) - 23), exact,
                         [&] { return "to_float of " + text_of(a); });
    }

    Device &device_;
    Kernel kernel_;
};

}  // namespace

void add_film(std::vector<SubjectEntry> &list) {
    list.push_back({"film", "core/integer128.cl, stages/accumulate.cl", "exact; to_float: 2^-23", 1,
                    [](Device &device) { return std::make_unique<FilmArithmetic>(device); }});
}

}  // namespace brandung
