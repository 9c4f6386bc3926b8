/// What vertices of triangles have, between them: places in pictures, and colours.
#include <fmt/format.h>

#include <array>

#include "kernels/core/scene.h"
#include "kernels/primitives/triangle.h"
#include "runtime/selftest/examine.h"
#include "runtime/selftest/extended.h"
#include "runtime/selftest/input_source.h"
#include "runtime/selftest/precision.h"
#include "runtime/selftest/subjects/list.h"
#include "scene/kinds.h"

namespace brandung {
namespace {

constexpr std::size_t inputs_per_round = 1 << 16;

/// Of a triangle, in one table: VertexUvs, 3 numbers of nothing, VertexColors.
constexpr uint numbers = 18, first_color = 9;

struct Cases {
    std::vector<float> table;
    std::vector<ShadingRecord> records;
    std::vector<vec2> weights;
};

/// As kernels have it, in float or in double.
template <class Number> struct PatternOf {
    std::array<Number, 2> uv;
    std::array<Number, 3> color;
};

/// At vertices, on edges, inside, and beyond an edge by rounding.
vec2 any_weights(InputSource &source) {
    const float u = source.uniform(0, 1), v = source.uniform(0, 1 - u);
    const vec2 choices[] = {{u, v}, {u, 1 - u}, {u, 0}, {0, u}, {float(source.below(2)), 0}, {u, 1 - u + source.power_of_two(-30, -22)}};
    return choices[source.below(6)];
}

Cases make_cases(std::uint64_t seed) {
    InputSource source(seed);
    Cases cases{std::vector<float>(numbers * inputs_per_round), std::vector<ShadingRecord>(inputs_per_round), {}};
    for (uint i = 0; i < inputs_per_round; ++i) {
        for (uint k = 0; k < numbers; ++k)
            cases.table[numbers * i + k] = k < first_color ? source.sign() * source.power_of_two(-20, 20) : source.uniform(0, 4);
        const TriangleShading shading = {.a = {}, .b = {}, .c = {}, .uvs = 1 + numbers / 6 * i, .colors = 1 + numbers / 9 * i + first_color / 9};
        write_words(shading, cases.records[i].words);
        cases.weights.push_back(any_weights(source));
    }
    return cases;
}

class VertexPatterns final : public Subject {
public:
    explicit VertexPatterns(Device &device) : device_(device), kernel_(device, "kernels/selftest/vertex_patterns.cl", "test_vertex_patterns") {}

    Findings examine(uint round) override {
        const Cases cases = make_cases(seed_of(15, round, 0));
        const auto results = run<float>(kernel_.in_float, cases);
        const auto doubles = kernel_.in_double ? run<double>(*kernel_.in_double, cases) : std::vector<PatternOf<double>>();
        device_.finish();
        return examine_each(inputs_per_round, [&](std::size_t i, Findings &findings) {
            const float *uvs = &cases.table[numbers * i], *colors = uvs + first_color;
            const PatternOf<double> *exact = kernel_.in_double ? &doubles[i] : nullptr;
            ++findings.hits;
            for (uint k = 0; k < 2; ++k)
                look_at(Quantity::uv, {uvs[k], uvs[2 + k], uvs[4 + k]}, cases.weights[i], results[i].uv[k], exact ? &exact->uv[k] : nullptr,
                        findings);
            for (uint k = 0; k < 3; ++k)
                look_at(Quantity::value, {colors[k], colors[3 + k], colors[6 + k]}, cases.weights[i], results[i].color[k],
                        exact ? &exact->color[k] : nullptr, findings);
        });
    }

private:
    template <class Number> std::vector<PatternOf<Number>> run(Kernel &kernel, const Cases &cases) {
        Buffer<PatternOf<Number>> results(device_, inputs_per_round);
        kernel(inputs_per_round, empty_header(device_), Buffer<Number>(device_, std::vector<Number>(cases.table.begin(), cases.table.end())),
               Buffer<ShadingRecord>(device_, cases.records),
               Buffer<glm::vec<2, Number>>(device_, std::vector<glm::vec<2, Number>>(cases.weights.begin(), cases.weights.end())),
               static_cast<uint>(inputs_per_round), results);
        return results.read();
    }

    /// The first weight has 2 roundings, of 1 and the others; products and sums 3 more. No colour counts less than nothing.
    static void look_at(Quantity quantity, std::array<float, 3> at, vec2 weights, float value, const double *in_double, Findings &findings) {
        const extended rest = 1 - extended(weights.x) - extended(weights.y), first = quantity == Quantity::value ? greater(rest, 0) : rest;
        const extended b = extended(at[1]) * weights.x, c = extended(at[2]) * weights.y, exact = at[0] * first + b + c;
        const double allowed = double(6 * unit_roundoff * (absolute(extended(at[0])) * (1 + weights.x + weights.y) + absolute(b) + absolute(c)));
        const double magnitude = double(absolute(exact));
        if (in_double) findings.rounding_of(quantity).add(std::abs(value - *in_double), allowed, ulp_of(exact), magnitude);
        findings.measure(quantity, double(absolute(value - exact)), allowed, ulp_of(exact), magnitude, [&] {
            return fmt::format("{:.9g}, and not {:.9g}, between {:a}, {:a} and {:a} by weights {:a} and {:a}", value, double(exact), at[0], at[1],
                               at[2], weights.x, weights.y);
        });
    }

    Device &device_;
    KernelInBoth kernel_;
};

}  // namespace

void add_vertex_patterns(std::vector<SubjectEntry> &list) {
    list.push_back({"vertex_patterns", "primitives/triangle.cl", "6 roundings of the terms", 2,
                    [](Device &device) { return std::make_unique<VertexPatterns>(device); }});
}

}  // namespace brandung
