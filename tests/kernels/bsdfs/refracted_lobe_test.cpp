/// Narrow lobes of what rough glass refracts, also where most of their facets reflect totally: samples are counted in cells as narrow as the lobes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/kernels/bsdfs/glass.h"
#include "tests/kernels/bsdfs/numbers.h"
#include "tests/support/statistics/chi_square.h"
#include "tests/support/statistics/significance.h"

namespace brandung {
namespace {

using glm::dvec3;

/// The unit square onto directions that facets refract wo into: by their normals' slope as GGX of this alpha has it, and by azimuth about z.
class RefractedCells {
public:
    static constexpr std::size_t columns = 16, cells = columns * columns;

    RefractedCells(vec3 wo, double eta, double alpha) : wo_(glm::normalize(dvec3(wo))), eta_(eta), alpha_(alpha) {}

    /// None where the facet reflects totally, is not seen, or refracts light to its own side of the surface.
    std::optional<dvec3> at(double u, double v) const {
        const double slope = alpha_ * std::sqrt(1 / (u * u) - 1), z = 1 / std::hypot(1, slope);
        const dvec3 h(slope * z * std::cos(2 * M_PI * v), slope * z * std::sin(2 * M_PI * v), z);
        const double cosine = glm::dot(wo_, h), square = 1 - eta_ * eta_ * (1 - cosine * cosine);
        if (cosine <= 0 || square <= 0) return {};
        const dvec3 wi = (eta_ * cosine - std::sqrt(square)) * h - eta_ * wo_;
        if (wi.z >= 0) return {};
        return wi;
    }
    /// Solid angle per area of the square, by differences.
    double solid_angle(double u, double v) const {
        constexpr double step = 1e-7;
        const auto a = at(u - step, v), b = at(u + step, v), c = at(u, v - step), d = at(u, v + step);
        return a && b && c && d ? glm::length(glm::cross(*b - *a, *d - *c)) / (4 * step * step) : 0;
    }
    std::optional<std::size_t> cell_of(dvec3 wi) const {
        if (wi.z >= 0) return {};
        const dvec3 sum = eta_ * wo_ + wi, h = sum * (sum.z > 0 ? 1.0 : -1.0) / glm::length(sum);
        if (glm::dot(wo_, h) <= 0 || glm::dot(wi, h) >= 0) return {};
        const double u = 1 / std::sqrt(1 + (h.x * h.x + h.y * h.y) / (h.z * h.z) / (alpha_ * alpha_)), v = std::atan2(h.y, h.x) / (2 * M_PI);
        return index(u) * columns + index(v < 0 ? v + 1 : v);
    }

private:
    static std::size_t index(double x) { return std::min(static_cast<std::size_t>(x * columns), columns - 1); }

    dvec3 wo_;
    double eta_, alpha_;
};

/// Of each cell, and of all other directions, by the density of the kernels.
std::vector<double> expected_in(const RefractedCells &cells, const ProbedBsdf &bsdf, vec3 wo) {
    constexpr std::size_t steps = 40, side = RefractedCells::columns * steps;
    std::vector<vec3> directions;
    std::vector<double> measures;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < side; ++i)
        for (std::size_t j = 0; j < side; ++j) {
            const double u = (double(i) + 0.5) / side, v = (double(j) + 0.5) / side;
            const auto wi = cells.at(u, v);
            if (!wi) continue;
            directions.emplace_back(*wi), measures.push_back(cells.solid_angle(u, v) / (side * side));
            places.push_back(i / steps * RefractedCells::columns + j / steps);
        }
    const std::vector<BsdfValue> values = bsdf.eval({wo}, directions);
    std::vector<double> expected(RefractedCells::cells + 1);
    double all = 0;
    for (std::size_t n = 0; n < values.size(); ++n) {
        const double part = double(values[n].pdf) * measures[n];
        expected[places[n]] += part, all += part;
    }
    EXPECT_LE(all, 1 + 1e-3);
    expected.back() = std::max(1 - all, 0.0);
    return expected;
}

std::vector<std::uint64_t> counts_in(const RefractedCells &cells, const std::vector<BsdfSample> &chosen) {
    std::vector<std::uint64_t> counts(RefractedCells::cells + 1);
    for (const BsdfSample &sample : chosen) ++counts[cells.cell_of(sample.wi).value_or(RefractedCells::cells)];
    return counts;
}

/// What light meets, and the angles of it [degrees].
struct Side {
    const char *name;
    float eta;
    std::vector<double> angles;
};

class RefractedLobe : public testing::TestWithParam<Side> {};

}  // namespace

TEST_P(RefractedLobe, SamplesAreDistributedAsTheirDensitySays) {
    const float eta = GetParam().eta;
    std::vector<double> p_values;
    for (const double roughness : {0.05, 0.1, 0.2})
        for (const char *distribution : {"ggx", "beckmann"}) {
            const ProbedBsdf bsdf =
                probed(fmt::format(R"({{"type": "dielectric", "roughness": {}, "distribution": "{}"}})", roughness, distribution), eta);
            for (const double angle : GetParam().angles) {
                const vec3 wo = direction(std::cos(angle * M_PI / 180), 0.6);
                const RefractedCells cells(wo, eta, roughness * roughness);
                const auto counts = counts_in(cells, bsdf.sample({wo}, random_numbers(1 << 17)));
                p_values.push_back(statistics::chi_square(counts, expected_in(cells, bsdf, wo)).p);
                EXPECT_GT(p_values.back(), 1e-5) << distribution << ", roughness " << roughness << ", " << angle << " degrees";
            }
        }
    EXPECT_TRUE(statistics::plausible(p_values));
}

/// The critical angle is at 41.81 degrees.
INSTANTIATE_TEST_SUITE_P(Glass, RefractedLobe,
                         testing::Values(Side{"Entering", 1 / 1.5f, {0, 45, 80}}, Side{"Leaving", 1.5f, {0, 30, 41}},
                                         Side{"NearTheCriticalAngle", 1.5f, {41.7, 41.81, 42}}),
                         [](const auto &info) { return std::string(info.param.name); });

}  // namespace brandung
