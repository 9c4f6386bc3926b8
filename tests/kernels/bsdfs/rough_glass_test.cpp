/// Rough interfaces: kernels/bsdfs/dielectric.cl and the tables of what their facets take from each other.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "kernels/bsdfs/dielectric.h"
#include "scene/bsdfs/losses.h"
#include "scene/kinds.h"
#include "tests/kernels/bsdfs/glass.h"
#include "tests/kernels/bsdfs/numbers.h"
#include "tests/support/probe.h"

namespace brandung {
namespace {

using glm::dvec3;

/// An interface as it is seen from one side.
struct Interface {
    double roughness;
    uint distribution;
    double eta;

    double alpha() const { return roughness * roughness; }
    ProbedBsdf seen_from(double eta_there) const {
        return probed(
            fmt::format(R"({{"type": "dielectric", "roughness": {}, "distribution": "{}"}})", roughness, distribution == 1 ? "beckmann" : "ggx"),
            eta_there);
    }
    ProbedBsdf bsdf() const { return seen_from(eta); }
};

void PrintTo(const Interface &interface, std::ostream *out) {
    *out << (interface.distribution == 1 ? "Beckmann" : "GGX") << ", roughness " << interface.roughness << ", eta " << interface.eta;
}

std::vector<Interface> interfaces(const std::vector<double> &roughnesses, const std::vector<double> &etas) {
    std::vector<Interface> result;
    for (const double roughness : roughnesses)
        for (const uint distribution : {0u, 1u})
            for (const double eta : etas) result.push_back({roughness, distribution, eta});
    return result;
}

/// Walter et al. (2007), in double: D, and Smith's Lambda.
double density(const Interface &interface, double cosine) {
    const double a2 = interface.alpha() * interface.alpha(), tangent2 = 1 / (cosine * cosine) - 1;
    const double ggx = a2 / std::pow(a2 + tangent2, 2), beckmann = std::exp(-tangent2 / a2) / a2;
    return (interface.distribution == 1 ? beckmann : ggx) / (M_PI * std::pow(cosine, 4));
}

double lambda(const Interface &interface, double cosine) {
    const double slope = interface.alpha() * std::sqrt(1 / (cosine * cosine) - 1);
    if (slope == 0) return 0;
    if (interface.distribution == 0) return (std::sqrt(1 + slope * slope) - 1) / 2;
    return (std::erf(1 / slope) - 1) / 2 + slope / (2 * std::sqrt(M_PI)) * std::exp(-1 / (slope * slope));
}

/// Of the two sides of a surface, each masked by facets of heights that are correlated; of light that is refracted from wo to wi the less apart the
/// less it is bent.
double seen_from_both(const Interface &interface, dvec3 wo, dvec3 wi) {
    const double a = lambda(interface, wo.z), b = lambda(interface, std::abs(wi.z)), bend = glm::length(wo + wi);
    return 1 / (1 + std::max(a, b) + (wi.z > 0 ? 1 : 1 - 1 / (1 + 4.41 * bend)) * std::min(a, b));
}

/// f(wo, wi) |cos| of one facet, without eta²: equations 20 and 21 of Walter et al., of which the latter is of light that goes from wo to wi.
double of_one_facet(const Interface &interface, dvec3 wo, dvec3 wi) {
    dvec3 h = wi.z > 0 ? wo + wi : -(interface.eta * wo + wi);
    const double length = glm::length(h);
    h *= (h.z > 0 ? 1 : -1) / length;
    const double cosine = glm::dot(wo, h), beyond = glm::dot(wi, h);
    if (cosine <= 0 || (wi.z < 0 && beyond >= 0)) return 0;
    const double f = fresnel_by_angles(std::min(cosine, 1.0), interface.eta);
    const double common = density(interface, h.z) * seen_from_both(interface, wo, wi) / wo.z;
    return wi.z > 0 ? f * common / 4 : (1 - f) * common * cosine * -beyond / (length * length);
}

/// Part of the light from everywhere below, or above, that f sends along wo: an integral over the sphere around the mean direction is not needed,
/// since facets' normals are gone through instead, of which this is the light that each sends on.
double lost_by_facets(const Interface &interface, double cosine) {
    const dvec3 wo = direction(cosine);
    const int steps = 200;
    double sum = 0, visible = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const double w = (i + 0.5) / steps, q = w * w * (3 - 2 * w), a = interface.alpha();
            const double slope = a * std::sqrt(interface.distribution == 1 ? -std::log1p(-q) : q / (1 - q)), z = 1 / std::hypot(1, slope);
            const dvec3 h(slope * z * std::cos(M_PI * (j + 0.5) / steps), slope * z * std::sin(M_PI * (j + 0.5) / steps), z);
            const double at_facet = glm::dot(wo, h), eta = interface.eta;
            if (at_facet <= 0) continue;
            const double weight = 6 * w * (1 - w) * at_facet / z, f = fresnel_by_angles(std::min(at_facet, 1.0), eta);
            const double square = 1 - eta * eta * (1 - at_facet * at_facet);
            const dvec3 up = 2 * at_facet * h - wo, down = square < 0 ? dvec3(0) : (eta * at_facet - std::sqrt(square)) * h - eta * wo;
            const auto part = [&](dvec3 wi) { return (1 + lambda(interface, cosine)) * seen_from_both(interface, wo, wi); };
            visible += weight, sum += weight * ((up.z > 0 ? f * part(up) : 0) + (down.z < 0 ? (1 - f) * part(down) : 0));
        }
    return 1 - sum / visible;
}

std::vector<vec3> numbers(std::size_t count, uint seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto next = [&] { return std::min(float(uniform(engine)), 0x1.fffffep-1f); };
    std::vector<vec3> result;
    for (std::size_t i = 0; i < count; ++i) {
        const float x = next(), y = next();
        result.emplace_back(x, y, next());
    }
    return result;
}

/// Without the radiance's eta².
double energy(const Interface &interface, const BsdfSample &sample) {
    return sample.weight.x / (sample.wi.z < 0 ? double(float(interface.eta)) * double(float(interface.eta)) : 1);
}

vec3 above(vec3 w) { return vec3(w.x, w.y, std::abs(w.z)); }

/// Directions all over the sphere.
std::vector<vec3> all_over(std::size_t count) {
    std::vector<vec3> result;
    for (const vec3 n : numbers(count, 8)) result.push_back(direction(2 * n.x - 1, 2 * M_PI * n.y));
    return result;
}

/// What is left of light that arrives from everywhere, on both sides together.
double albedo(const Interface &interface, double cosine) {
    static const std::vector<vec3> from = even_numbers(1 << 18);
    double sum = 0;
    for (const BsdfSample &sample : interface.bsdf().sample({direction(cosine)}, from)) sum += energy(interface, sample);
    return sum / double(from.size());
}

/// The table's, of an interface.
struct LossesFound {
    std::vector<float> at;  ///< cosines
    float mean;
};

Material losing(float alpha, uint distribution) {
    Dielectric view{};
    view.alpha = alpha, view.distribution = distribution;
    Material result{};
    result.flags = MATERIAL_LOSES;
    write_words(view, result.words);
    return result;
}

LossesFound losses_found(const Interface &interface, const std::vector<double> &cosines) {
    static Probe probe(R"(#include "kernels/bsdfs/losses.cl"
        kernel void probe(const global Material *m, const global float *alpha, const global float *eta, const global float *cosines, global float *found) {
            const uint i = get_global_id(0);
            const Losses losses = losses_of(m, *alpha, *eta);
            found[i] = cosines[i] > 1.0f ? mean_loss(losses) : loss(losses, cosines[i]);
        })");
    const auto alpha = float(interface.alpha());
    std::vector<float> asked(cosines.begin(), cosines.end());
    asked.push_back(2);
    std::vector<float> found = probe.run<float>(with_loss_table(losing(alpha, interface.distribution)), alpha, float(interface.eta), asked);
    const float mean = found[cosines.size()];
    found.resize(cosines.size());
    return {found, mean};
}

}  // namespace

/// What is left of the value without the light of one facet is that of several: a diffuse lobe, the same for all azimuths.
TEST(RoughDielectric, LightOfOneFacetIsThatOfWalterAndOthers) {
    for (const Interface &interface : interfaces({0.3, 0.6, 1}, {1 / 1.5, 1.33})) {
        SCOPED_TRACE(testing::PrintToString(interface));
        for (const double cosine : {0.9, 0.7, 0.2}) {
            const vec3 wo = direction(cosine, 1);
            std::vector<vec3> wi;
            for (const vec3 n : numbers(1000, 3))
                for (const float turns : {n.y, n.z}) wi.push_back(direction(2 * n.x - 1, 2 * M_PI * turns));
            const auto values = interface.bsdf().eval({wo}, wi);
            const auto exact = [&](std::size_t i) { return of_one_facet(interface, wo, wi[i]); };
            const auto of_others = [&](std::size_t i) { return values[i].value.x / (wi[i].z < 0 ? interface.eta * interface.eta : 1) - exact(i); };
            for (std::size_t i = 0; i < wi.size(); i += 2) {
                ASSERT_GE(of_others(i), -2e-5 * (1 + exact(i))) << wi[i].x << ", " << wi[i].y << ", " << wi[i].z;
                ASSERT_NEAR(of_others(i), of_others(i + 1), 2e-5 * (1 + exact(i) + exact(i + 1))) << wi[i].x << ", " << wi[i].y << ", " << wi[i].z;
            }
        }
    }
}

/// f(wo, wi) / eta² of one side is that of the other (Veach 1997, 5.2); above the surface f is symmetric. Near the critical angle rounding of the
/// cosine beyond counts ten thousand times.
TEST(RoughDielectric, IsReciprocal) {
    for (const Interface &interface : interfaces({0.2, 0.5, 1}, {1 / 1.5, 1.5, 1 / 1.1, 2.2})) {
        SCOPED_TRACE(testing::PrintToString(interface));
        // On one side both ways are seen from it; from two sides, the way back from the other.
        for (const float side : {1.0f, -1.0f}) {
            std::vector<vec3> wo, wi, wo_back, wi_back;
            const std::vector<vec3> directions = all_over(4000);
            for (std::size_t i = 0; i < directions.size(); i += 2) {
                const vec3 a = above(directions[i]), b = above(directions[i + 1]);
                wo.push_back(a), wi.push_back(b * side), wo_back.push_back(b), wi_back.push_back(a * side);
            }
            const double factor = side < 0 ? interface.eta * interface.eta : 1;
            const std::vector<BsdfValue> there = interface.bsdf().eval(wo, wi);
            const std::vector<BsdfValue> back = interface.seen_from(side < 0 ? 1 / interface.eta : interface.eta).eval(wo_back, wi_back);
            for (std::size_t i = 0; i < there.size(); ++i) {
                const double f = there[i].value.x / std::abs(wi[i].z), g = back[i].value.x / std::abs(wi_back[i].z) * factor;
                ASSERT_NEAR(f, g, 2e-3 * (f + g) + 1e-7) << "from " << wi[i].z << " to " << wo[i].z;
            }
        }
    }
}

/// The white furnace.
TEST(RoughDielectric, LosesNoLight) {
    for (const Interface &interface : interfaces({0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.85, 1}, {1 / 2.4, 1 / 1.5, 1.02, 1.13, 1.5, 2.4}))
        for (const double cosine : {1.0, 0.5, 0.2, 0.0872})
            EXPECT_NEAR(albedo(interface, cosine), 1, 0.005) << testing::PrintToString(interface) << ", cosine " << cosine;
}

/// Between media that are nearly alike it is nearly not there, as it is not between equal ones.
TEST(RoughDielectric, VanishesAsMediaBecomeAlike) {
    const std::vector<vec3> from = even_numbers(1 << 14);
    for (const Interface &interface : interfaces({0.3, 0.6, 1}, {1 / 1.00001, 1.00001, 1.001}))
        for (const double cosine : {1.0, 0.5, 0.174, 0.0872}) {
            const vec3 wo = direction(cosine);
            double straight = 0;
            for (const BsdfSample &sample : interface.bsdf().sample({wo}, from))
                if (glm::length(sample.wi + wo) < 0.1f) straight += energy(interface, sample) / double(from.size());
            EXPECT_NEAR(straight, 1, interface.eta > 1.0005 ? 0.08 : 0.003) << testing::PrintToString(interface) << ", cosine " << cosine;
        }
}

/// Nor of indices that are met nowhere: the table has rows up to those which differ from all larger ones by nothing.
TEST(RoughDielectric, MakesNoLightAtAnyRatioOfIndices) {
    for (const Interface &interface : interfaces({0.1, 0.4, 1}, {1e-15, 1e-3, 0.05, 0.2, 0.999, 1.001, 5, 20, 1e3, 1e15}))
        for (const double cosine : {1.0, 0.5, 0.1})
            EXPECT_NEAR(albedo(interface, cosine), 1, 0.005) << testing::PrintToString(interface) << ", cosine " << cosine;
}

/// Of any angle, and of materials of other kinds, whose words may be any. Facets are drawn with a chance that is never small, though at grazing
/// angles nearly all of their light may be lost.
TEST(RoughDielectric, IsFinite) {
    for (const Interface &interface : interfaces({0.01, 0.05, 0.3, 1}, {0.1, 1 / 1.5, 0.9999, 1.0001, 1.5, 10}))
        for (const double cosine : {1.0, 0.5, 1e-3, 1e-6, 1e-20}) {
            SCOPED_TRACE(testing::PrintToString(interface));
            std::vector<vec3> extremes = numbers(500, 9);
            for (const float x : {0.0f, 0x1.fffffep-1f})
                for (const float y : {0.0f, 0x1.fffffep-1f})
                    for (const float z : {0.0f, 0x1.fffffep-1f}) extremes.emplace_back(x, y, z);
            for (const BsdfSample &sample : interface.bsdf().sample({direction(cosine)}, extremes)) {
                ASSERT_TRUE(std::isfinite(sample.wi.x + sample.wi.y + sample.wi.z));
                ASSERT_TRUE(sample.weight.x >= 0 && sample.weight.x <= 20 * std::max(1.0, interface.eta * interface.eta))
                    << sample.weight.x << " at " << cosine << " to " << sample.wi.z << " of density " << sample.pdf;
                ASSERT_TRUE(sample.pdf >= 0) << sample.pdf;
            }
        }
}

TEST(DielectricLosses, AreThoseOfIntegrals) {
    const std::vector<double> cosines = {0.0872, 0.1, 0.3, 0.6, 1};
    for (const Interface &interface : interfaces({0.2, 0.5, 1}, {1 / 1.7, 1 / 1.3, 1.13, 1.5, 2})) {
        SCOPED_TRACE(testing::PrintToString(interface));
        const LossesFound found = losses_found(interface, cosines);
        for (std::size_t i = 0; i < cosines.size(); ++i)
            EXPECT_NEAR(found.at[i], lost_by_facets(interface, cosines[i]), 0.005) << "cosine " << cosines[i];
        double sum = 0;
        for (int i = 0; i < 16; ++i) sum += 2 * (i + 0.5) / 16 * lost_by_facets(interface, (i + 0.5) / 16) / 16;
        EXPECT_NEAR(found.mean, sum, 0.005);
    }
}

/// So that the lobes have as much light as facets lose.
TEST(DielectricLosses, HaveTheMeanOfWhatIsBetweenTheirPlaces) {
    constexpr int angles = 20000;
    std::vector<double> cosines;
    for (int i = 0; i < angles; ++i) cosines.push_back((i + 0.5) / angles);
    for (const Interface &interface : interfaces({0.1, 0.4, 1}, {0.7, 1.4})) {
        const LossesFound found = losses_found(interface, cosines);
        double mean = 0;
        for (int i = 0; i < angles; ++i) mean += 2 * cosines[std::size_t(i)] * double(found.at[std::size_t(i)]) / angles;
        EXPECT_NEAR(found.mean, mean, 2e-4 * mean) << testing::PrintToString(interface);
    }
}

/// Materials of the same facets have the same one, those that nothing is made of have none.
TEST(DielectricLosses, AreATableForEachAlphaAndDistribution) {
    const std::vector<Material> materials = {losing(0.1f, 0), losing(0.1f, 1), Material{}, losing(0.1f, 0), losing(0.3f, 0)};
    const std::vector<std::byte> records = with_losses(materials, {true, true, true, true, false});
    ASSERT_EQ(records.size(), 5 * sizeof(Material) + 2 * sizeof(LossTable));
    const auto table = [&](std::size_t m) {
        const auto *at = reinterpret_cast<const Material *>(records.data()) + m;
        return reinterpret_cast<const std::byte *>(at->words + view_of<Dielectric>(at->words).losses) - records.data();
    };
    EXPECT_EQ(table(0), 5 * sizeof(Material));
    EXPECT_EQ(table(3), table(0));
    EXPECT_EQ(table(1), table(0) + sizeof(LossTable));
    EXPECT_EQ(with_losses({Material{}}, {true}).size(), sizeof(Material));
}

}  // namespace brandung
