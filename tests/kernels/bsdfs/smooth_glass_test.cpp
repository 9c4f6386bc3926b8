/// What goes on in single directions: smooth interfaces, thin sheets, nothing at all: kernels/bsdfs/dielectric.cl, thin_dielectric.cl, null.cl.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/kernels/bsdfs/glass.h"

namespace brandung {
namespace {

const std::vector<double> etas = {1 / 2.4, 1 / 1.5, 1 / 1.33, 0.999, 1.001, 1.33, 1.5, 2.4};
const std::vector<double> cosines = {1, 0.99, 0.9, 0.7, 0.5, 0.3, 0.1, 0.01, 1e-4};
const Spectrum mirror_factor(0.9f, 0.8f, 0.7f), passing_factor(0.6f, 0.5f, 0.4f);
const std::string factors = R"("reflection": [0.9, 0.8, 0.7], "transmission": [0.6, 0.5, 0.4]})";
const std::string glass = R"({"type": "dielectric", )" + factors, sheet = R"({"type": "thin_dielectric", )" + factors;
constexpr float always = 0, never = 0x1.fffffep-1f;  ///< numbers that choose the mirrored and the other ray, where there are both

BsdfSample sample(const std::string &text, vec3 wo, double eta, float choice) {
    return probed(text, eta).sample({wo}, {vec3(0.3f, 0.6f, choice)})[0];
}

void expect_single(const BsdfSample &sample, vec3 wi, Spectrum weight, double tolerance) {
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(sample.wi[c], wi[c], tolerance);
        EXPECT_FLOAT_EQ(sample.weight[c], weight[c]);
    }
    EXPECT_EQ(sample.pdf, std::numeric_limits<float>::infinity());
}

/// The number below which the choice is the mirrored ray.
double chance_of_mirroring(const std::string &text, vec3 wo, double eta) {
    const std::size_t steps = 1 << 16;
    std::vector<vec3> numbers;
    for (std::size_t i = 0; i < steps; ++i) numbers.emplace_back(0.5f, 0.5f, (float(i) + 0.5f) / float(steps));
    double mirrored = 0;
    for (const BsdfSample &s : probed(text, eta).sample({wo}, numbers)) mirrored += s.wi.z > 0;
    return mirrored / double(steps);
}

TEST(SmoothDielectric, ObeysSnellsLaw) {
    for (const double eta : etas)
        for (const double cosine : cosines) {
            const vec3 wo = direction(cosine, 0.7);
            const double sine = eta * std::hypot(double(wo.x), double(wo.y));
            if (sine > 0.9999) continue;
            SCOPED_TRACE(testing::Message() << "eta " << eta << ", cosine " << cosine);
            const vec3 beyond(-eta * wo.x, -eta * wo.y, -std::sqrt(1 - sine * sine));
            // The cosine has the error of its square over twice itself.
            expect_single(sample(glass, wo, eta, never), beyond, passing_factor * float(eta) * float(eta), 3e-7 * eta / std::sqrt(1 - sine * sine));
        }
}

TEST(SmoothDielectric, MirrorsInTheNormal) {
    for (const double eta : etas)
        for (const double cosine : cosines) {
            const vec3 wo = direction(cosine, 0.7);
            if (fresnel_by_angles(cosine, eta) > 0) expect_single(sample(glass, wo, eta, always), {-wo.x, -wo.y, wo.z}, mirror_factor, 1e-7);
        }
}

/// What is not mirrored passes, and both weights are the factors: nothing is lost.
TEST(SmoothDielectric, FresnelsLawDividesTheLight) {
    for (const double eta : {1 / 1.5, 1.33})
        for (const double cosine : {1.0, 0.8, 0.5, 0.2, 0.05})
            EXPECT_NEAR(chance_of_mirroring(glass, direction(cosine), eta), fresnel_by_angles(cosine, eta), 2e-5) << eta << ", " << cosine;
}

TEST(SmoothDielectric, ReflectsTotallyBeyondTheCriticalAngle) {
    const double critical = std::sqrt(1 - 1 / (1.5 * 1.5));
    for (const double cosine : {critical * 0.9999, 0.5, 0.1, 1e-3}) {
        const vec3 wo = direction(cosine, 2);
        expect_single(sample(glass, wo, 1.5, never), {-wo.x, -wo.y, wo.z}, mirror_factor, 1e-7);
    }
    EXPECT_LT(sample(glass, direction(critical * 1.0001, 2), 1.5, never).wi.z, 0);
}

/// Rough or not.
TEST(SmoothDielectric, OfEqualMediaIsNone) {
    for (const std::string &text : {glass, R"({"type": "dielectric", "roughness": 0.5, )" + factors})
        for (const double cosine : cosines)
            for (const float choice : {always, 0.5f, never}) {
                const vec3 wo = direction(cosine, 4);
                const BsdfSample s = sample(text, wo, 1, choice);
                EXPECT_EQ(s.wi, -wo);
                EXPECT_EQ(s.weight, passing_factor);
                EXPECT_EQ(s.pdf, std::numeric_limits<float>::infinity());
                const BsdfValue value = probed(text, 1).eval({wo}, {-wo})[0];
                EXPECT_EQ(value.value, Spectrum(0));
                EXPECT_EQ(value.pdf, 0);
            }
}

TEST(SmoothDielectric, LightFromElsewhereHasNoPartInIt) {
    for (const std::string &text : {glass, sheet})
        for (const vec3 wi : {direction(0.8), -direction(0.8), direction(0.1, 3), vec3(1, 0, 0)}) {
            const BsdfValue value = probed(text, 1.5).eval({direction(0.8, M_PI)}, {wi})[0];
            EXPECT_EQ(value.value, Spectrum(0));
            EXPECT_EQ(value.pdf, 0);
        }
}

/// Light that goes to and fro in the sheet, term by term.
TEST(ThinDielectric, SumsTheInnerReflections) {
    for (const double eta : {1 / 2.4, 1 / 1.5, 1 / 1.1})
        for (const double cosine : {1.0, 0.8, 0.5, 0.2, 0.05}) {
            const double f = fresnel_by_angles(cosine, eta);
            double mirrored = f, inside = (1 - f) * f;
            for (int i = 0; i < 1000; ++i) mirrored += inside * (1 - f), inside *= f * f;
            EXPECT_NEAR(chance_of_mirroring(sheet, direction(cosine), eta), mirrored, 2e-5) << eta << ", " << cosine;
        }
}

TEST(ThinDielectric, LightPassesStraightOn) {
    for (const double cosine : cosines) {
        const vec3 wo = direction(cosine, 5);
        expect_single(sample(sheet, wo, 1 / 1.5, never), -wo, passing_factor, 0);
        expect_single(sample(sheet, wo, 1 / 1.5, always), {-wo.x, -wo.y, wo.z}, mirror_factor, 0);
        expect_single(sample(sheet, wo, 1, always), -wo, passing_factor, 0);
    }
}

TEST(Null, LightPassesStraightOnInEveryMedium) {
    const std::string tinted = R"({"type": "null", "transmission": [0.6, 0.5, 0.4]})";
    for (const double eta : etas)
        for (const double cosine : cosines)
            for (const float choice : {always, never})
                expect_single(sample(tinted, direction(cosine, 5), eta, choice), -direction(cosine, 5), passing_factor, 0);
    const BsdfValue value = probed(tinted, 1).eval({direction(0.8, M_PI)}, {-direction(0.8, M_PI)})[0];
    EXPECT_EQ(value.value, Spectrum(0));
    EXPECT_EQ(value.pdf, 0);
}

}  // namespace
}  // namespace brandung
