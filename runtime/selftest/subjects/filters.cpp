/// Where filters put samples: against the inverse of an integral of the filter itself.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/selftest/examine.h"
#include "runtime/selftest/extended.h"
#include "runtime/selftest/input_source.h"
#include "runtime/selftest/precision.h"
#include "runtime/selftest/subjects/list.h"
#include "scene/filters/filter.h"

namespace brandung {
namespace {

constexpr std::size_t inputs_per_round = 1 << 16;

/// As kernels have it, in float or in double.
template <class Number> struct FilterParamsOf {
    Number radius, negative_tail;
    uint weight;
};

/// How far from the centre, the radius being 1, some of the mass of |f| lies further out: |f| is taken to be linear between 2^16 places.
class MassBeyond {
public:
    explicit MassBeyond(double (*value)(double)) {
        for (std::size_t i = 0; i <= cells; ++i) {
            heights_.push_back(std::abs(value(double(i) / cells)));
            within_.push_back(i == 0 ? 0 : within_.back() + (heights_[i - 1] + heights_[i]) / 2);
        }
    }

    double place(double mass) const {
        const double wanted = within_.back() * (1 - mass);
        const auto after = std::upper_bound(within_.begin() + 1, within_.end() - 1, wanted);
        const std::size_t i = static_cast<std::size_t>(after - within_.begin()) - 1;
        const double rest = std::max(wanted - within_[i], 0.0), from = heights_[i], rise = heights_[i + 1] - from;
        const double root = from + std::sqrt(std::max(from * from + 2 * rise * rest, 0.0));
        return (double(i) + (root > 0 ? std::min(2 * rest / root, 1.0) : 0.0)) / cells;
    }

private:
    static constexpr std::size_t cells = 1 << 16;
    std::vector<double> heights_, within_;
};

/// As random numbers are: multiples of 2^-24 below 1; the ends and the middle often.
float any_random(InputSource &source) {
    const uint end = 1u << 24, steps[] = {source.below(end), source.below(16), end - 1 - source.below(16), end / 2 - 8 + source.below(16)};
    return float(steps[source.below(4)]) * 0x1p-24f;
}

class FilterPlaces final : public Subject {
public:
    FilterPlaces(Device &device, const FilterKind &kind)
        : device_(device),
          kind_(kind),
          mass_(kind.value),
          kernel_(device, "kernels/selftest/filters.cl", "test_filter_places",
                  {{"generated/filter.cl", fmt::format("#include \"kernels/filters/{}.cl\"\n", kind.file)}}) {}

    Findings examine(uint round) override {
        InputSource source(seed_of(16, round, 0));
        const float radius = kind_.has_radius ? source.uniform(0.5, 8) : kind_.radius;
        std::vector<float> randoms(inputs_per_round);
        for (float &random : randoms) random = any_random(source);
        const std::vector<float> places = run<float>(kernel_.in_float, radius, randoms);
        const std::vector<double> doubles = kernel_.in_double ? run<double>(*kernel_.in_double, radius, randoms) : std::vector<double>();
        device_.finish();
        return examine_each(inputs_per_round, [&](std::size_t i, Findings &findings) {
            look_at(radius, randoms[i], places[i], kernel_.in_double ? &doubles[i] : nullptr, findings);
        });
    }

private:
    template <class Number> std::vector<Number> run(Kernel &kernel, float radius, const std::vector<float> &randoms) {
        const FilterParams params = filter_params(kind_, radius);
        std::vector<float> table = filter_table(kind_, radius);
        if (table.empty()) table.push_back(0);  // buffers have at least one element
        Buffer<Number> places(device_, randoms.size());
        kernel(randoms.size(), FilterParamsOf<Number>{params.radius, params.negative_tail, params.weight},
               Buffer<Number>(device_, std::vector<Number>(table.begin(), table.end())),
               Buffer<Number>(device_, std::vector<Number>(randoms.begin(), randoms.end())), static_cast<uint>(randoms.size()), places);
        return places.read();
    }

    /// How far places may be from the true one that a table's ends of intervals have: those are right, and what lies between them does so in between.
    double table_error(double mass, double exact) const {
        if (!kind_.tabulated) return 0;
        const double interval = std::floor((1 - std::sqrt(mass)) * FILTER_INTERVALS * (1 + 0x1p-22));
        const auto at = [&](double i) {
            const double beyond = 1 - std::clamp(i / FILTER_INTERVALS, 0.0, 1.0);
            return mass_.place(beyond * beyond);
        };
        return std::max(exact - at(interval - 1), at(interval + 1) - exact) + 0x1p-20;
    }

    /// Roots have 1 rounding, the rest up to 7 of numbers as large as radius and place.
    void look_at(float radius, float random, float place, const double *in_double, Findings &findings) const {
        const bool is_left = random < 0.5f;
        const double mass = 2 * (is_left ? double(random) : 1 - double(random)), distance = mass_.place(mass);
        const double exact = 0.5 + (is_left ? -1 : 1) * radius * distance, magnitude = std::max(std::abs(exact), double(radius));
        const double allowed = 8 * unit_roundoff * magnitude + radius * table_error(mass, distance);
        ++findings.hits;
        if (in_double) findings.rounding_of(Quantity::value).add(std::abs(place - *in_double), allowed, ulp_of(magnitude), magnitude);
        findings.measure(Quantity::value, std::abs(place - exact), allowed, ulp_of(magnitude), magnitude,
                         [&] { return fmt::format("{:a} of radius {:a} lies at {:.9g}, and not {:.9g}", random, radius, place, exact); });
    }

    Device &device_;
    const FilterKind &kind_;
    MassBeyond mass_;
    KernelInBoth kernel_;
};

}  // namespace

void add_filters(std::vector<SubjectEntry> &list) {
    for (const FilterKind &kind : filter_kinds())
        list.push_back({std::string("filter_") + kind.name, fmt::format("filters/{}.cl", kind.file),
                        kind.tabulated ? "8 roundings, and places between those of the table" : "8 roundings", 2,
                        [&kind](Device &device) { return std::make_unique<FilterPlaces>(device, kind); }});
}

}  // namespace brandung
