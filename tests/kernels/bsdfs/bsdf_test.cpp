/// What integrators ask of every kind of material that they may choose directions by.
#include <gtest/gtest.h>

#include "tests/kernels/bsdfs/direction_cells.h"
#include "tests/kernels/bsdfs/numbers.h"
#include "tests/kernels/bsdfs/probed_bsdf.h"
#include "tests/support/scenes.h"
#include "tests/support/statistics/chi_square.h"
#include "tests/support/statistics/significance.h"

namespace brandung {
namespace {

constexpr std::size_t samples = 1 << 17;

class Bsdf : public testing::TestWithParam<TestedMaterial> {
protected:
    ProbedBsdf bsdf{GetParam()};
};

vec3 at_angle(double degrees) {
    const double angle = degrees * M_PI / 180, azimuth = 0.6;
    return vec3(std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle));
}

/// Of each cell, and beyond its last element the part of the samples that none has: what lobes of a single direction have, and what is lost.
std::vector<double> expected_in(const DirectionCells &cells, const ProbedBsdf &bsdf, vec3 wo) {
    constexpr std::size_t steps = 32, side = DirectionCells::columns * steps;
    std::vector<vec3> directions;
    std::vector<double> measures;
    for (std::size_t i = 0; i < side; ++i)
        for (std::size_t j = 0; j < side; ++j) {
            const DirectionCells::Point point = cells.at((double(i) + 0.5) / side, (double(j) + 0.5) / side);
            directions.emplace_back(point.direction), measures.push_back(point.solid_angle / (side * side));
        }
    const std::vector<BsdfValue> values = bsdf.eval({wo}, directions);
    std::vector<double> expected(DirectionCells::cells + 1);
    double all = 0;
    for (std::size_t n = 0; n < values.size(); ++n) {
        const double part = double(values[n].pdf) * measures[n];
        expected[n / side / steps * DirectionCells::columns + n % side / steps] += part, all += part;
    }
    EXPECT_LE(all, 1 + 2e-3);
    expected.back() = std::max(1 - all, 0.0);
    return expected;
}

std::vector<std::uint64_t> counts_in(const DirectionCells &cells, const std::vector<BsdfSample> &chosen) {
    std::vector<std::uint64_t> counts(DirectionCells::cells + 1);
    for (const BsdfSample &sample : chosen) {
        const bool in_lobe = sample.pdf > 0 && std::isfinite(sample.pdf);
        ++counts[in_lobe ? cells.cell_of(sample.wi).value_or(DirectionCells::cells) : DirectionCells::cells];
    }
    return counts;
}

}  // namespace

TEST_P(Bsdf, SamplesAreDistributedAsTheirDensitySays) {
    std::vector<double> p_values;
    for (const double angle : {0.0, 45.0, 80.0}) {
        const vec3 wo = at_angle(angle);
        const DirectionCells cells(wo, GetParam().width);
        const std::vector<std::uint64_t> counts = counts_in(cells, bsdf.sample({wo}, random_numbers(samples)));
        if (counts.back() == samples) continue;  // an ideal surface
        const auto test = statistics::chi_square(counts, expected_in(cells, bsdf, wo));
        p_values.push_back(test.p);
    }
    if (p_values.empty()) return;
    EXPECT_TRUE(statistics::plausible(p_values));
}

TEST_P(Bsdf, WeightsAreWhatIsReflectedOverItsDensity) {
    for (const double angle : {0.0, 45.0, 80.0}) {
        const vec3 wo = at_angle(angle);
        const std::vector<BsdfSample> chosen = bsdf.sample({wo}, random_numbers(4096));
        std::vector<vec3> directions;
        for (const BsdfSample &sample : chosen) directions.push_back(sample.wi);
        const std::vector<BsdfValue> values = bsdf.eval({wo}, directions);
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            ASSERT_NEAR(glm::length(glm::dvec3(chosen[i].wi)), 1, 1e-6);
            if (!std::isfinite(chosen[i].pdf)) continue;
            ASSERT_NEAR(chosen[i].pdf, values[i].pdf, 1e-5 * values[i].pdf);
            for (int c = 0; c < 3; ++c) ASSERT_NEAR(chosen[i].weight[c] * chosen[i].pdf, values[i].value[c], 1e-5 * values[i].value[c]);
        }
    }
}

/// f itself: of `value` the cosine is taken away. Near the critical angle rounding of the cosine beyond counts more.
TEST_P(Bsdf, IsTheSameWithTheDirectionsExchanged) {
    if (!GetParam().reciprocal) return;
    const vec3 wo = at_angle(50);
    std::vector<vec3> directions;
    for (const BsdfSample &sample : bsdf.sample({wo}, random_numbers(4096)))
        if (std::isfinite(sample.pdf) && sample.wi.z > 0.01f) directions.push_back(sample.wi);
    if (directions.empty()) return;  // an ideal surface
    const std::vector<BsdfValue> there = bsdf.eval({wo}, directions), back = bsdf.eval(directions, std::vector<vec3>(directions.size(), wo));
    const double rounding = GetParam().eta > 1 ? 5e-4 : 1e-4;
    for (std::size_t i = 0; i < directions.size(); ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(double(there[i].value[c]) / directions[i].z, double(back[i].value[c]) / wo.z, rounding * there[i].value[c] / directions[i].z);
}

/// The mean weight of samples, without the factor of radiance beyond an interface, by numbers spread evenly.
TEST_P(Bsdf, ReflectsNoMoreThanArrives) {
    const std::vector<vec3> numbers = even_numbers(samples);
    for (const double angle : {0.0, 30.0, 60.0, 75.0, 85.0}) {
        glm::dvec3 albedo(0);
        for (const BsdfSample &sample : bsdf.sample({at_angle(angle)}, numbers)) {
            const double eta = sample.wi.z < 0 ? GetParam().eta : 1;
            albedo += glm::dvec3(sample.weight) / (eta * eta * double(numbers.size()));
        }
        const double white = GetParam().white;
        for (int c = 0; c < 3; ++c) {
            EXPECT_LE(albedo[c], 1 + std::max(white, 1e-3)) << angle;
            EXPECT_GE(albedo[c], white > 0 ? 1 - white : 0.0) << angle;
        }
    }
}

TEST_P(Bsdf, IsFiniteAndNotNegativeAtAnyAngle) {
    Random random(3);
    std::vector<vec3> wo, wi, numbers = random_numbers(1 << 15);
    for (vec3 &u : numbers) {
        vec3 w = random.direction();
        w.z = std::max(std::abs(w.z), 1e-7f);
        const float low = std::exp2(random.uniform(-40, 0));
        if (random.below(2) == 0) w = vec3(w.x, w.y, w.z * low);
        wo.push_back(glm::normalize(w));
        vec3 v = random.direction();
        if (random.below(2) == 0) v.z *= low;
        wi.push_back(random.below(8) == 0 ? wo.back() : glm::normalize(v));
        for (int c = 0; c < 3; ++c) u[c] = random.below(8) > 0 ? u[c] : random.below(2) == 0 ? 0 : below_one;
    }
    const std::vector<BsdfValue> values = bsdf.eval(wo, wi);
    const std::vector<BsdfSample> chosen = bsdf.sample(wo, numbers);
    for (std::size_t i = 0; i < wo.size(); ++i) {
        ASSERT_TRUE(values[i].pdf >= 0 && std::isfinite(values[i].pdf)) << values[i].pdf;
        ASSERT_TRUE(chosen[i].pdf >= 0) << chosen[i].pdf;
        for (int c = 0; c < 3; ++c) {
            ASSERT_TRUE(values[i].value[c] >= 0 && std::isfinite(values[i].value[c])) << values[i].value[c];
            ASSERT_TRUE(chosen[i].weight[c] >= 0 && chosen[i].weight[c] < 20) << chosen[i].weight[c] << " at " << wo[i].z;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Bsdf, testing::ValuesIn(tested_materials()), [](const auto &info) { return std::string(info.param.name); });

}  // namespace brandung
