/// The kernels' own elementary functions against long double's, whose 64 bits of mantissa leave 2^-40 ulp of a float.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "runtime/opencl/kernel.h"
#include "runtime/selftest/examine.h"
#include "runtime/selftest/input_source.h"
#include "runtime/selftest/subjects/list.h"

namespace brandung {
namespace {

constexpr const char *file = "kernels/selftest/math.cl";
constexpr std::size_t inputs_per_round = 1 << 20;
constexpr float infinity = std::numeric_limits<float>::infinity();

using Arguments = std::array<float, 4>;

struct Function {
    const char *name;
    long double (*exact)(const Arguments &);
    double bound;        ///< as kernels/core says it
    bool bound_is_ulps;  ///< of the result, or an absolute error
    /// Number `index` of a round's arguments; rounds * inputs_per_round go through all floats where there is one argument.
    Arguments (*arguments)(InputSource &source, std::uint64_t index);
};

long double wide(float x) { return x; }

/// All floats in 4096 rounds, each evenly strided.
Arguments any_one(InputSource &, std::uint64_t index) {
    constexpr std::uint64_t rounds = (std::uint64_t{1} << 32) / inputs_per_round;
    const std::uint64_t round = index / inputs_per_round * 1021 % rounds, bits = index % inputs_per_round * rounds + round;
    return {std::bit_cast<float>(static_cast<std::uint32_t>(bits))};
}

Arguments unit_interval(InputSource &source, std::uint64_t) {
    if (source.one_in(4)) return {source.below(9) / 8.0f + (source.one_in(2) ? 0 : -0x1p-24f * source.below(2))};
    return {source.uniform(0, 1)};
}
Arguments in_unit_interval(InputSource &source, std::uint64_t index) {
    Arguments arguments = unit_interval(source, index);
    arguments[0] = std::clamp(arguments[0], 0.0f, 1.0f);
    return arguments;
}

/// With log2(x^y) in [low, high).
Arguments with_exponent(InputSource &source, float x, float low, float high) { return {x, x == 1 ? low : source.uniform(low, high) / std::log2(x)}; }
float positive(InputSource &source) { return std::bit_cast<float>(1 + static_cast<std::uint32_t>((source.bits() >> 32) % 0x7f7fffff)); }

/// Anything; results from end to end; bases near 1; sharp lobes; gammas; at overflow; subnormal results and bases; the special cases.
Arguments for_power(InputSource &source, std::uint64_t) {
    const float ends[] = {0, 0x1p-149f, 0x1p-126f, 0.5f, 1 - 0x1p-24f, 1, 1 + 0x1p-23f, 2, 1e5f, 0x1.fffffep127f, infinity, NAN};
    switch (source.below(9)) {
        case 0:
            return {std::abs(source.any_float()), source.any_float()};
        case 1:
            return with_exponent(source, positive(source), -150, 128);
        case 2:
            return with_exponent(source, 1 + source.uniform(-1, 1) * source.power_of_two(-24, -2), -150, 128);
        case 3:
            return {source.uniform(0.99, 1), source.power_of_two(0, 17)};
        case 4:
            return {source.uniform(0, 1), source.uniform(0, 5)};
        case 5:
            return with_exponent(source, positive(source), 127.9f, 128.1f);
        case 6:
            return with_exponent(source, positive(source), -151, -125);
        case 7:
            return with_exponent(source, std::abs(source.subnormal()) + 0x1p-149f, -150, 128);
        default:
            return {ends[source.below(12)], ends[source.below(12)] * source.sign()};
    }
}

/// Alike, or of any size up to 2^126, the greatest for which the bound is promised.
Arguments for_arctangent(InputSource &source, std::uint64_t) {
    const auto any = [&] {
        const float x = source.one_in(8) ? source.subnormal() : source.any_float();
        return std::abs(x) <= 0x1p126f ? x : source.one_in(2) ? 0.0f : 1.0f;
    };
    const float x = source.uniform(-1, 1);
    if (source.one_in(4)) return {any(), any()};
    if (source.one_in(4)) return {x * (1 + source.uniform(-1, 1) * source.power_of_two(-23, -1)) * source.sign(), x};
    return {source.uniform(-1, 1), x};
}

/// Products that cancel more or less, far from where they underflow.
Arguments for_products(InputSource &source, std::uint64_t) {
    const auto number = [&] { return source.sign() * source.power_of_two(-20, 20); };
    const float a = number(), b = number(), c = number(), quotient = a * b / c;
    return {a, b, c, source.one_in(2) ? quotient * (1 + source.uniform(-1, 1) * source.power_of_two(-24, 0)) : quotient};
}

/// Turns are reduced exactly first.
long double angle_of(float turns) { return 2 * std::numbers::pi_v<long double> * turns; }

const Function functions[] = {
    {"exponential", [](const Arguments &a) { return std::exp(wide(a[0])); }, 0.92, true, any_one},
    {"logarithm", [](const Arguments &a) { return std::log(wide(a[0])); }, 0.501, true, any_one},
    {"power", [](const Arguments &a) { return std::pow(wide(a[0]), wide(a[1])); }, 0.96, true, for_power},
    {"arctangent", [](const Arguments &a) { return std::atan2(wide(a[0]), wide(a[1])); }, 2.25, true, for_arctangent},
    {"turn_cosine", [](const Arguments &a) { return std::cos(angle_of(a[0])); }, 8e-8, false, in_unit_interval},
    {"turn_sine", [](const Arguments &a) { return std::sin(angle_of(a[0])); }, 8e-8, false, in_unit_interval},
    {"next_up", [](const Arguments &a) { return wide(std::nextafter(a[0], infinity)); }, 0, true, any_one},
    {"next_down", [](const Arguments &a) { return wide(std::nextafter(a[0], -infinity)); }, 0, true, any_one},
    {"difference_of_products", [](const Arguments &a) { return wide(a[0]) * a[1] - wide(a[2]) * a[3]; }, 1.5, true, for_products},
};

class ElementaryFunction final : public Subject {
public:
    ElementaryFunction(Device &device, const Function &function)
        : device_(device), function_(function), kernel_(device, file, std::string("test_") + function.name, {}) {}

    Findings examine(uint round) override {
        std::array<std::vector<float>, 4> columns;
        for (auto &column : columns) column.resize(inputs_per_round);
        for_parts(inputs_per_round, [&](std::size_t first, std::size_t last) {
            InputSource source(seed_of(2, round, first));
            for (std::size_t i = first; i < last; ++i) {
                const Arguments arguments = function_.arguments(source, std::uint64_t{round} * inputs_per_round + i);
                for (std::size_t k = 0; k < 4; ++k) columns[k][i] = arguments[k];
            }
        });
        Buffer<float> results(device_, inputs_per_round);
        const auto argument = [&](std::size_t k) { return Buffer<float>(device_, columns[k]); };
        kernel_(inputs_per_round, argument(0), argument(1), argument(2), argument(3), static_cast<uint>(inputs_per_round), results);
        const std::vector<float> values = results.read();
        device_.finish();
        return examine_each(inputs_per_round, [&](std::size_t i, Findings &findings) {
            look_at({columns[0][i], columns[1][i], columns[2][i], columns[3][i]}, values[i], findings);
        });
    }

private:
    /// Infinity counts as 2^128 unless the exact result rounds to it, and NaN is right where both are.
    void look_at(const Arguments &arguments, float value, Findings &findings) const {
        const long double exact = function_.exact(arguments);
        ++findings.hits;
        const bool same = (std::isinf(value) && static_cast<float>(exact) == value) || (std::isnan(value) && std::isnan(exact));
        const long double finite = std::isinf(value) ? std::copysign(0x1p128L, static_cast<long double>(value)) : value;
        const double error = same ? 0 : static_cast<double>(std::abs(finite - exact)), ulp = ulp_of_result(exact);
        findings.measure(Quantity::value, std::isnan(error) ? infinity : error, function_.bound * (function_.bound_is_ulps ? ulp : 1), ulp,
                         error == 0 ? infinity : static_cast<double>(std::abs(exact)), [&] {
                             return fmt::format("of {:a}, {:a}, {:a}, {:a}: {:a}, but it is {:.9g}", arguments[0], arguments[1], arguments[2],
                                                arguments[3], value, static_cast<double>(exact));
                         });
    }
    static double ulp_of_result(long double exact) {
        if (exact == 0 || !std::isfinite(exact)) return exact == 0 ? 0x1p-149 : 0x1p104;
        return std::ldexp(1.0, std::clamp(std::ilogb(exact) - 23, -149, 104));
    }

    Device &device_;
    const Function &function_;
    Kernel kernel_;
};

}  // namespace

void add_math(std::vector<SubjectEntry> &list) {
    for (const Function &function : functions)
        list.push_back({function.name, "core/math.cl", fmt::format("{:g} {}", function.bound, function.bound_is_ulps ? "ulp" : "absolute"), 1,
                        [&function](Device &device) { return std::make_unique<ElementaryFunction>(device, function); }});
}

}  // namespace brandung
