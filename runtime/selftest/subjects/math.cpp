/// Functions of numbers. Single operations, which must be those of IEEE 754 and stay single, against the host's; all others against long double's,
/// whose 64 bits of mantissa leave 2^-40 ulp of a float.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "runtime/selftest/examine.h"
#include "runtime/selftest/input_source.h"
#include "runtime/selftest/precision.h"
#include "runtime/selftest/subjects/list.h"

namespace brandung {
namespace {

constexpr std::size_t inputs_per_round = 1 << 20;
constexpr float infinity = std::numeric_limits<float>::infinity();

using Arguments = std::array<float, 4>;
using Columns = std::array<std::vector<float>, 4>;

/// Sum of these; all 0: to the last bit.
struct Bound {
    double ulps = 0;  ///< of the exact result
    double absolute = 0;
    double roundings = 0;                                                        ///< of the terms that it is made of, half an ulp each,
    double (*terms)(const Arguments &) = [](const Arguments &) { return 0.0; };  ///< which sum to this
    bool is_exact() const { return ulps == 0 && absolute == 0 && roundings == 0; }
};

struct Function {
    const char *name, *file;
    long double (*exact)(const Arguments &);
    Bound bound;  ///< as the kernel's comment says it
    /// Number `index` of all rounds' arguments.
    Arguments (*arguments)(InputSource &source, std::uint64_t index);
};

long double wide(float x) { return x; }

/// All floats in 4096 rounds, each evenly strided.
Arguments any_one(InputSource &, std::uint64_t index) {
    constexpr std::uint64_t rounds = (std::uint64_t{1} << 32) / inputs_per_round;
    const std::uint64_t round = index / inputs_per_round * 1021 % rounds, bits = index % inputs_per_round * rounds + round;
    return {std::bit_cast<float>(static_cast<std::uint32_t>(bits))};
}

/// Of any size, subnormal ones too; sums that cancel all but the last digits of a product.
Arguments for_arithmetic(InputSource &source, std::uint64_t) {
    const auto number = [&] {
        if (source.one_in(16)) return source.subnormal();
        return source.one_in(4) ? source.any_float() : source.sign() * source.power_of_two(-30, 30);
    };
    const float a = number(), b = number();
    return {a, b, source.one_in(2) ? -(a * b) : number()};
}

/// And the eighths, where the quarters meet, with their neighbours.
Arguments for_turn(InputSource &source, std::uint64_t) {
    const float eighth = source.below(9) / 8.0f, beside = eighth + float(int(source.below(3)) - 1) * 0x1p-24f;
    return {source.one_in(4) ? std::clamp(beside, 0.0f, 1.0f) : source.uniform(0, 1)};
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

/// Cosines from grazing to normal incidence, media from alike to far apart, and angles about that of total reflection.
Arguments for_refraction(InputSource &source, std::uint64_t) {
    const float eta = source.one_in(4) ? 1 + source.sign() * source.power_of_two(-24, -1) : source.power_of_two(-3, 3);
    const double critical = std::sqrt(std::max(0.0, 1 - 1 / (double(eta) * eta)));
    const float cosines[] = {source.uniform(0, 1), source.power_of_two(-40, 0), 1 - source.power_of_two(-24, 0),
                             float(critical * (1 + source.uniform(-1, 1) * source.power_of_two(-24, -1)))};
    return {std::clamp(source.one_in(64) ? float(source.below(2)) : cosines[source.below(4)], 0.0f, 1.0f), eta};
}

/// For the squared cosine beyond that the other function gives there, but for rounding.
Arguments for_fresnel(InputSource &source, std::uint64_t index) {
    const auto [cosine, eta, unused, also_unused] = for_refraction(source, index);
    const double beyond = 1 - double(eta) * eta * (1 - double(cosine)) * (1 + double(cosine));
    return {cosine, float(beyond), eta};
}

double refraction_terms(const Arguments &a) { return double(a[1]) * a[1] * (1 - double(a[0])) * (1 + double(a[0])); }

long double refracted_cosine_squared(const Arguments &a) { return 1 - wide(a[1]) * a[1] * (1 - wide(a[0])) * (1 + wide(a[0])); }

/// By the amplitudes' ratios; where both media are alike and the ray grazes, nothing is reflected.
long double fresnel(const Arguments &a) {
    const long double inside = a[0], eta = a[2], beyond = std::sqrt(std::max(wide(a[1]), 0.0L));
    if (a[1] < 0) return 1;
    const auto ratio = [](long double x, long double y) { return x + y == 0 ? 0 : (x - y) / (x + y); };
    const long double s = ratio(eta * inside, beyond), p = ratio(inside, eta * beyond);
    return (s * s + p * p) / 2;
}

/// In 64 bits, which its multiplications are taken modulo 2^32 from.
long double hash_in_unit_interval(const Arguments &a) {
    constexpr std::uint64_t mask = 0xffffffffu;
    std::uint64_t x = std::bit_cast<std::uint32_t>(a[0]);
    x = (x ^ x / 65536) * 0x7feb352du & mask;
    x = (x ^ x / 32768) * 0x846ca68bu & mask;
    return static_cast<long double>((x ^ x / 65536) / 256) / 16777216;
}

long double angle_of(float turns) { return 2 * std::numbers::pi_v<long double> * turns; }

constexpr const char *portable = "core/portable.h", *math = "core/math.cl", *refraction = "core/refraction.cl";
const Function functions[] = {
    {"multiply_then_add", portable, [](const Arguments &a) { return wide(a[0] * a[1] + a[2]); }, {}, for_arithmetic},
    {"fused_multiply_add", portable, [](const Arguments &a) { return wide(std::fma(a[0], a[1], a[2])); }, {}, for_arithmetic},
    {"divide", portable, [](const Arguments &a) { return wide(a[0] / a[1]); }, {}, for_arithmetic},
    {"square_root", portable, [](const Arguments &a) { return wide(std::sqrt(a[0])); }, {}, for_arithmetic},
    {"exponential", math, [](const Arguments &a) { return std::exp(wide(a[0])); }, {.ulps = 0.92}, any_one},
    {"logarithm", math, [](const Arguments &a) { return std::log(wide(a[0])); }, {.ulps = 0.501}, any_one},
    {"power", math, [](const Arguments &a) { return std::pow(wide(a[0]), wide(a[1])); }, {.ulps = 0.96}, for_power},
    {"arctangent", math, [](const Arguments &a) { return std::atan2(wide(a[0]), wide(a[1])); }, {.ulps = 2.25}, for_arctangent},
    {"turn_cosine", math, [](const Arguments &a) { return std::cos(angle_of(a[0])); }, {.absolute = 8e-8}, for_turn},
    {"turn_sine", math, [](const Arguments &a) { return std::sin(angle_of(a[0])); }, {.absolute = 8e-8}, for_turn},
    {"next_up", math, [](const Arguments &a) { return wide(std::nextafter(a[0], infinity)); }, {}, any_one},
    {"next_down", math, [](const Arguments &a) { return wide(std::nextafter(a[0], -infinity)); }, {}, any_one},
    {"difference_of_products",
     "core/vec_functions.cl",
     [](const Arguments &a) { return wide(a[0]) * a[1] - wide(a[2]) * a[3]; },
     {.ulps = 1.5},
     for_products},
    {"refracted_cosine_squared", refraction, refracted_cosine_squared, {.ulps = 1, .roundings = 6, .terms = refraction_terms}, for_refraction},
    {"fresnel", refraction, fresnel, {.absolute = 0x1p-21}, for_fresnel},
    {"hash", "core/random.cl", hash_in_unit_interval, {}, any_one},
};

std::string text_of(const Bound &bound) {
    std::string text;
    const auto add = [&](double x, const char *unit) { text += x == 0 ? "" : fmt::format("{}{:.3g}{}", text.empty() ? "" : " + ", x, unit); };
    add(bound.ulps, " ulp"), add(bound.absolute, ""), add(bound.roundings, " roundings of the terms");
    return text.empty() ? "exact" : text;
}

class ElementaryFunction final : public Subject {
public:
    ElementaryFunction(Device &device, const Function &function)
        : device_(device),
          function_(function),
          kernel_(device, "kernels/selftest/math.cl", std::string("test_") + function.name, {}, !function.bound.is_exact()) {}

    Findings examine(uint round) override {
        const Columns columns = make_columns(round);
        const std::vector<float> values = run<float>(kernel_.in_float, columns);
        const std::vector<double> doubles = kernel_.in_double ? run<double>(*kernel_.in_double, columns) : std::vector<double>();
        device_.finish();
        return examine_each(inputs_per_round, [&](std::size_t i, Findings &findings) {
            const Arguments arguments = {columns[0][i], columns[1][i], columns[2][i], columns[3][i]};
            look_at(arguments, values[i], kernel_.in_double ? &doubles[i] : nullptr, findings);
        });
    }

private:
    Columns make_columns(uint round) const {
        Columns columns;
        for (auto &column : columns) column.resize(inputs_per_round);
        for_parts(inputs_per_round, [&](std::size_t first, std::size_t last) {
            InputSource source(seed_of(2, round, first));
            for (std::size_t i = first; i < last; ++i) {
                const Arguments arguments = function_.arguments(source, std::uint64_t{round} * inputs_per_round + i);
                for (std::size_t k = 0; k < 4; ++k) columns[k][i] = arguments[k];
            }
        });
        return columns;
    }

    template <class Number> std::vector<Number> run(Kernel &kernel, const Columns &columns) {
        Buffer<Number> results(device_, inputs_per_round);
        const auto argument = [&](std::size_t k) { return Buffer<Number>(device_, std::vector<Number>(columns[k].begin(), columns[k].end())); };
        kernel(inputs_per_round, argument(0), argument(1), argument(2), argument(3), static_cast<uint>(inputs_per_round), results);
        return results.read();
    }

    /// Infinity counts as 2^128 unless the exact result rounds to it, and NaN is right where both are.
    static double distance(float value, long double exact) {
        if ((std::isinf(value) && static_cast<float>(exact) == value) || (std::isnan(value) && std::isnan(exact))) return 0;
        const long double finite = std::isinf(value) ? std::copysign(0x1p128L, static_cast<long double>(value)) : value;
        const double error = static_cast<double>(std::abs(finite - exact));
        return std::isnan(error) ? infinity : error;
    }

    void look_at(const Arguments &arguments, float value, const double *in_double, Findings &findings) const {
        const long double exact = function_.exact(arguments);
        ++findings.hits;
        const double ulp = ulp_of_result(exact), magnitude = static_cast<double>(std::abs(exact));
        const Bound &bound = function_.bound;
        const double allowed = bound.ulps * ulp + bound.absolute + bound.roundings * 0x1p-24 * bound.terms(arguments);
        if (in_double) findings.rounding_of(Quantity::value).add(distance(value, *in_double), allowed, ulp, magnitude);
        findings.measure(Quantity::value, distance(value, exact), allowed, ulp, magnitude, [&] {
            return fmt::format("of {:a}, {:a}, {:a}, {:a}: {:a}, but it is {:.9g}", arguments[0], arguments[1], arguments[2], arguments[3], value,
                               static_cast<double>(exact));
        });
    }
    static double ulp_of_result(long double exact) {
        if (exact == 0 || !std::isfinite(exact)) return exact == 0 ? 0x1p-149 : 0x1p104;
        return std::ldexp(1.0, std::clamp(std::ilogb(exact) - 23, -149, 104));
    }

    Device &device_;
    const Function &function_;
    KernelInBoth kernel_;
};

}  // namespace

void add_math(std::vector<SubjectEntry> &list) {
    for (const Function &function : functions)
        list.push_back({function.name, function.file, text_of(function.bound), 1,
                        [&function](Device &device) { return std::make_unique<ElementaryFunction>(device, function); }});
}

}  // namespace brandung
