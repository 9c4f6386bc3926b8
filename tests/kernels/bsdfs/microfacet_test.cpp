/// kernels/bsdfs/microfacet.cl against double precision.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "tests/support/probe.h"
#include "tests/support/scenes.h"

namespace brandung {
namespace {

double reflectance(double cosine, std::complex<double> index) {
    const std::complex<double> beyond = std::sqrt(1.0 - (1 - cosine) * (1 + cosine) / (index * index));
    const std::complex<double> s = (cosine - index * beyond) / (cosine + index * beyond), p = (index * cosine - beyond) / (index * cosine + beyond);
    return (std::norm(s) + std::norm(p)) / 2;
}

}  // namespace

/// Of indices from those of noble metals to those of dielectrics that are denser than what surrounds them.
TEST(Microfacet, ConductorsReflectByFresnelsLaw) {
    Random random(5);
    std::vector<vec3> cases;
    for (int i = 0; i < 1 << 16; ++i) {
        const float grazing = random.below(8) == 0 ? 1e-3f : 1;
        const float eta = std::exp2(random.uniform(-5, 3));
        cases.emplace_back(grazing * random.uniform(0, 1), eta, eta > 1 && random.below(4) == 0 ? 0 : random.uniform(0.1f, 8));
    }
    const std::vector<float> results = Probe(R"(#include "kernels/bsdfs/microfacet.cl"
        kernel void probe(const global vec3 *x, global float *results) {
            const uint i = get_global_id(0);
            results[i] = conductor_fresnel(x[i].x, x[i].y, x[i].z);
        })",
                                             {{"generated/constants.h", "#define FACETS 3u\n"}})
                                           .run<float>(cases);
    for (std::size_t i = 0; i < cases.size(); ++i)
        ASSERT_NEAR(results[i], reflectance(cases[i].x, {cases[i].y, cases[i].z}), 2e-6) << cases[i].x << " " << cases[i].y << " " << cases[i].z;
}

}  // namespace brandung
