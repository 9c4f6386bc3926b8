/// kernels/core/math.cl against extended precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/probe.h"

namespace {

using brandung::Probe;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float least = std::numeric_limits<float>::denorm_min();
constexpr float greatest = std::numeric_limits<float>::max();
constexpr std::size_t pairs = 1 << 19;

/// |value - exact| in units in the last place of `exact`; infinity counts as 2^128, and a NaN is right if both are.
long double ulps(float value, long double exact) {
    if (static_cast<float>(exact) == value || (std::isnan(value) && std::isnan(exact))) return 0;
    const long double finite = std::isinf(value) ? std::copysign(0x1p128L, value) : value;
    const long double error = std::abs(finite - exact) / std::ldexp(1.0L, std::clamp(std::ilogb(exact) - 23, -149, 104));
    return std::isnan(error) ? infinity : error;
}

/// Floats from all over the 2^32, evenly strided by bits.
std::vector<float> floats_of_all_kinds() {
    std::vector<float> result;
    for (std::uint64_t bits = 0; bits < 1ull << 32; bits += 1021) result.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    return result;
}

class Random {
public:
    float uniform(float low, float high) { return std::uniform_real_distribution(low, high)(engine); }
    float any_float() { return std::bit_cast<float>(static_cast<std::uint32_t>(engine())); }
    float positive_float() { return std::bit_cast<float>(1 + static_cast<std::uint32_t>(engine() % 0x7f7fffff)); }

private:
    std::mt19937 engine{1};
};

std::vector<float> values_of(const char *function, const std::vector<float> &x) {
    return Probe(std::string("#include \"kernels/core/math.cl\"\n") +
                 "kernel void probe(const global float *x, global float *y) { const uint i = get_global_id(0); y[i] = " + function + "(x[i]); }")
        .run<float>(x);
}

std::vector<float> power(const std::vector<float> &x, const std::vector<float> &y) {
    Probe probe(R"(#include "kernels/core/math.cl"
        kernel void probe(const global float *x, const global float *y, global float *z) {
            const uint i = get_global_id(0);
            z[i] = power(x[i], y[i]);
        })");
    return probe.run<float>(x, y);
}

/// Checks power on pairs that `sample` makes.
template <class Sample> void expect_power_within_its_error(Sample sample) {
    Random random;
    std::vector<float> x, y;
    for (std::size_t i = 0; i < pairs; ++i) {
        const auto [base, exponent] = sample(random);
        x.push_back(base);
        y.push_back(exponent);
    }
    const std::vector<float> z = power(x, y);
    for (std::size_t i = 0; i < pairs; ++i)
        ASSERT_LE(ulps(z[i], std::pow(static_cast<long double>(x[i]), static_cast<long double>(y[i]))), 0.96) << x[i] << " to the " << y[i];
}

/// A pair (x, y) with log2(x^y) in [low, high).
std::pair<float, float> with_exponent(Random &random, float x, float low, float high) {
    return {x, x == 1 ? low : random.uniform(low, high) / std::log2(x)};
}

}  // namespace

TEST(Math, ExponentialIsWithinItsError) {
    const std::vector<float> x = floats_of_all_kinds(), y = values_of("exponential", x);
    for (std::size_t i = 0; i < x.size(); ++i) ASSERT_LE(ulps(y[i], std::exp(static_cast<long double>(x[i]))), 0.92) << x[i];
}

TEST(Math, ExponentialOfTheEnds) {
    EXPECT_EQ(values_of("exponential", {0, -0.0f, least, infinity, -infinity, greatest, -greatest, 88.8f, -104}),
              (std::vector<float>{1, 1, 1, infinity, 0, infinity, 0, infinity, 0}));
}

TEST(Math, LogarithmIsWithinItsError) {
    const std::vector<float> x = floats_of_all_kinds(), y = values_of("logarithm", x);
    for (std::size_t i = 0; i < x.size(); ++i) ASSERT_LE(ulps(y[i], std::log(static_cast<long double>(x[i]))), 0.501) << x[i];
}

TEST(Math, LogarithmOfTheEnds) {
    EXPECT_EQ(values_of("logarithm", {0, -0.0f, 1, infinity}), (std::vector<float>{-infinity, -infinity, 0, infinity}));
    for (const float y : values_of("logarithm", {-least, -1, -infinity, not_a_number})) EXPECT_TRUE(std::isnan(y));
}

TEST(Math, PowerIsWithinItsErrorForAnyPair) {
    expect_power_within_its_error([](Random &random) { return std::pair{std::abs(random.any_float()), random.any_float()}; });
}

TEST(Math, PowerIsWithinItsErrorWhereTheResultIsFinite) {
    expect_power_within_its_error([](Random &random) { return with_exponent(random, random.positive_float(), -150, 128); });
}

TEST(Math, PowerIsWithinItsErrorNearOne) {
    expect_power_within_its_error([](Random &random) {
        const float distance = std::exp2(random.uniform(-24, -2));
        return with_exponent(random, 1 + random.uniform(-1, 1) * distance, -150, 128);
    });
}

TEST(Math, PowerIsWithinItsErrorForSharpLobes) {
    expect_power_within_its_error([](Random &random) { return std::pair{random.uniform(0.99f, 1), std::exp(random.uniform(0, std::log(1e5f)))}; });
}

TEST(Math, PowerIsWithinItsErrorForGammas) {
    expect_power_within_its_error([](Random &random) { return std::pair{random.uniform(0, 1), random.uniform(0, 5)}; });
}

TEST(Math, PowerIsWithinItsErrorNearOverflow) {
    expect_power_within_its_error([](Random &random) { return with_exponent(random, random.positive_float(), 127.9f, 128.1f); });
}

TEST(Math, PowerIsWithinItsErrorForSubnormalResults) {
    expect_power_within_its_error([](Random &random) { return with_exponent(random, random.positive_float(), -151, -125); });
}

TEST(Math, PowerIsWithinItsErrorForSubnormalBases) {
    expect_power_within_its_error([](Random &random) { return with_exponent(random, random.uniform(0, 1) * 0x1p-126f, -150, 128); });
}

TEST(Math, PowerOfTheEndsIsThatOfC) {
    const float ends[] = {0,    least,    0x1p-126f, 0.5f,        std::nextafter(1.0f, 0.0f), 1, std::nextafter(1.0f, 2.0f), 2,
                          1e5f, greatest, infinity,  not_a_number};
    std::vector<float> x, y;
    for (const float base : ends)
        for (const float magnitude : ends)
            for (const float exponent : {magnitude, -magnitude}) {
                x.push_back(base);
                y.push_back(exponent);
            }
    const std::vector<float> z = power(x, y);
    for (std::size_t i = 0; i < x.size(); ++i)
        EXPECT_LE(ulps(z[i], std::pow(static_cast<long double>(x[i]), static_cast<long double>(y[i]))), 0.96) << x[i] << " to the " << y[i];
}

TEST(Math, ErrorFunctionIsWithinItsError) {
    Random random;
    std::vector<float> x = {0, infinity};
    for (std::size_t i = 0; i < pairs; ++i) x.push_back(random.uniform(0, 6));
    Probe probe(R"(#include "kernels/core/math.cl"
        kernel void probe(const global float *x, global float *y) {
            const uint i = get_global_id(0);
            y[i] = error_function(x[i], exponential(-x[i] * x[i]));
        })");
    const std::vector<float> y = probe.run<float>(x);
    for (std::size_t i = 0; i < x.size(); ++i) ASSERT_NEAR(y[i], std::erf(double(x[i])), 4e-7) << x[i];
}

TEST(Math, InverseErrorFunctionIsWithinItsError) {
    Random random;
    std::vector<float> x = {std::nextafter(1.0f, 0.0f), -std::nextafter(1.0f, 0.0f), 0};
    for (std::size_t i = 0; i < pairs; ++i) x.push_back(i % 2 == 0 ? random.uniform(-1, 1) : 1 - std::exp2(random.uniform(-24, 0)));
    const std::vector<float> y = values_of("inverse_error_function", x);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double exact = boost::math::erf_inv(double(x[i]));
        ASSERT_LE(std::abs(y[i] - exact), 3e-7 * std::abs(exact)) << x[i];
    }
}

std::vector<float> arctangent(const std::vector<float> &y, const std::vector<float> &x) {
    Probe probe(R"(#include "kernels/core/math.cl"
        kernel void probe(const global float *y, const global float *x, global float *angle) {
            const uint i = get_global_id(0);
            angle[i] = arctangent(y[i], x[i]);
        })");
    return probe.run<float>(y, x);
}

TEST(Math, ArctangentIsWithinItsError) {
    Random random;
    std::vector<float> y, x;
    for (std::size_t i = 0; i < pairs; ++i) {
        const bool alike = i % 4 != 0;  // else of any size up to 2^126
        y.push_back(alike ? random.uniform(-1, 1) : random.any_float()), x.push_back(alike ? random.uniform(-1, 1) : random.any_float());
        for (float *part : {&y.back(), &x.back()})
            if (!(std::abs(*part) <= 0x1p126f)) *part = 1;
    }
    const std::vector<float> angle = arctangent(y, x);
    for (std::size_t i = 0; i < pairs; ++i)
        ASSERT_LE(ulps(angle[i], std::atan2(static_cast<long double>(y[i]), static_cast<long double>(x[i]))), 2.25) << y[i] << ' ' << x[i];
}

TEST(Math, ArctangentOnAxesAndAtTheOriginIsThatOfC) {
    std::vector<float> y, x;
    for (const float a : {0.0f, -0.0f, 1.0f, -1.0f, least, -least, 0x1p126f})
        for (const float b : {0.0f, -0.0f, 1.0f, -1.0f, least, -least, 0x1p126f}) y.push_back(a), x.push_back(b);
    const std::vector<float> angle = arctangent(y, x);
    for (std::size_t i = 0; i < y.size(); ++i) {
        const float expected = std::atan2(y[i], x[i]);
        EXPECT_LE(ulps(angle[i], expected), 1) << y[i] << ' ' << x[i];
        EXPECT_EQ(std::signbit(angle[i]), std::signbit(expected)) << y[i] << ' ' << x[i];
    }
}

TEST(Math, NextUpAndNextDownAreTheNeighbours) {
    std::vector<float> x = floats_of_all_kinds();
    x.insert(x.end(), {0, -0.0f, least, -least, 0x1p-126f, 1, -1, greatest, -greatest, infinity, -infinity, not_a_number});
    const std::vector<float> up = values_of("next_up", x), down = values_of("next_down", x);
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (std::isnan(x[i])) {
            ASSERT_TRUE(std::isnan(up[i]) && std::isnan(down[i]));
        } else {
            ASSERT_EQ(std::bit_cast<std::uint32_t>(up[i]), std::bit_cast<std::uint32_t>(std::nextafter(x[i], infinity))) << x[i];
            ASSERT_EQ(std::bit_cast<std::uint32_t>(down[i]), std::bit_cast<std::uint32_t>(std::nextafter(x[i], -infinity))) << x[i];
        }
    }
}

TEST(Math, DifferenceOfProductsIsWithinItsErrorHoweverMuchCancels) {
    Random random;
    std::vector<float> a(pairs), b(pairs), c(pairs), d(pairs);
    for (std::size_t i = 0; i < pairs; ++i) {
        a[i] = random.uniform(-10, 10);
        b[i] = random.uniform(-10, 10);
        c[i] = random.uniform(1, 10);
        d[i] = i % 2 ? random.uniform(-10, 10) : a[i] * b[i] / c[i];
    }
    Probe probe(R"(#include "kernels/core/math.cl"
        kernel void probe(const global float *a, const global float *b, const global float *c, const global float *d, global float *result) {
            const uint i = get_global_id(0);
            result[i] = difference_of_products(a[i], b[i], c[i], d[i]);
        })");
    const std::vector<float> result = probe.run<float>(a, b, c, d);
    for (std::size_t i = 0; i < pairs; ++i) {
        const long double exact = static_cast<long double>(a[i]) * b[i] - static_cast<long double>(c[i]) * d[i];
        ASSERT_LE(ulps(result[i], exact), 1.5) << a[i] << ' ' << b[i] << ' ' << c[i] << ' ' << d[i];
    }
}

TEST(Math, MinimumMaximum) {
    Probe probe(R"(#include "kernels/core/math.cl"
        kernel void probe(const global float *x, const global float *y, global float *z) {
            const uint i = get_global_id(0);
            z[i] = 100.0f * minimum(x[i], y[i]) + maximum(x[i], y[i]);
        })");
    EXPECT_EQ(probe.run<float>(std::vector<float>{2, 5, -3}, std::vector<float>{7, 4, -3}), (std::vector<float>{207, 405, -303}));
}
