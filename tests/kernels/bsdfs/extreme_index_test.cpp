/// Indices of refraction at the ends of what scenes may have: nothing becomes infinite or no number.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "scene/bsdfs/index_of_refraction.h"
#include "tests/kernels/bsdfs/glass.h"
#include "tests/kernels/bsdfs/numbers.h"

namespace brandung {
namespace {

bool are_numbers(Spectrum s) { return std::isfinite(s.x) && std::isfinite(s.y) && std::isfinite(s.z) && s.x >= 0 && s.y >= 0 && s.z >= 0; }

/// Directions from straight above to grazing ones, and samples of each; the lobes are evaluated for these too, and through the interface.
void expect_numbers(const std::string &text, double ratio) {
    SCOPED_TRACE(testing::Message() << text << ", ratio " << ratio);
    const ProbedBsdf bsdf = probed(text, ratio);
    for (const double cosine : {1.0, 0.9999999, 0.9, 0.3, 1e-3, 1e-6}) {
        const vec3 wo = direction(cosine, 0.7);
        std::vector<vec3> directions;
        for (const BsdfSample &sample : bsdf.sample({wo}, random_numbers(512))) {
            ASSERT_TRUE(are_numbers(sample.weight)) << "cosine " << cosine;
            ASSERT_FALSE(std::isnan(sample.pdf)) << "cosine " << cosine;
            ASSERT_NEAR(glm::length(glm::dvec3(sample.wi)), 1, 1e-3) << "cosine " << cosine;
            directions.push_back(sample.wi), directions.push_back(-sample.wi);
        }
        for (const BsdfValue &value : bsdf.eval({wo}, directions)) {
            ASSERT_TRUE(are_numbers(value.value)) << "cosine " << cosine;
            ASSERT_TRUE(std::isfinite(value.pdf)) << "cosine " << cosine;
        }
    }
}

}  // namespace

TEST(ExtremeIndex, OfMediaGivesNumbers) {
    for (const double ratio : {double(max_index) / min_index, double(min_index) / max_index})
        for (const char *material :
             {R"({"type": "dielectric"})", R"({"type": "dielectric", "roughness": 0.01})", R"({"type": "dielectric", "roughness": 1})",
              R"({"type": "dielectric", "roughness": 0.3, "distribution": "beckmann"})", R"({"type": "thin_dielectric"})",
              R"({"type": "whitted", "transmission": 1, "reflection": 1, "fresnel": true})"})
            expect_numbers(material, ratio);
}

TEST(ExtremeIndex, OfCoatsGivesNumbers) {
    for (const double eta : {1.0000002, double(max_index)})
        for (const double roughness : {0.0, 0.5})
            expect_numbers(fmt::format(R"({{"type": "plastic", "diffuse": 1, "nonlinear": true, "eta": {}, "roughness": {}}})", eta, roughness), 1);
}

TEST(ExtremeIndex, OfMetalsGivesNumbers) {
    for (const double eta : {0.0, double(max_metal_index)})
        for (const double k : {0.0, double(max_metal_index)})
            expect_numbers(fmt::format(R"({{"type": "conductor", "eta": {}, "k": {}}})", eta, k), 1);
}

}  // namespace brandung
