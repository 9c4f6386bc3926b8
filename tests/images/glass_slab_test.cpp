/// Light through a plate of glass, all that its faces send to and fro with it, to a tenth of a percent.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "scene/kinds.h"
#include "scene/samplers/sampler.h"
#include "tests/images/irradiance.h"
#include "tests/scene/formats/temporary_file.h"

namespace {

using namespace brandung;
using namespace irradiance;

constexpr std::size_t intervals = 4;  ///< of this file's tests
constexpr Real eta = 1.5L;

/// Of a plate in air: (1 - F)² + F² (1 - F)² + F⁴ (1 - F)² + ... of one ray's light passes.
Real transmittance(Real cosine) {
    const Real f = oracle::fresnel(cosine, 1 / eta);
    return (1 - f) / (1 + f);
}

/// Of light from all sides, by Simpson's rule.
Real diffuse_transmittance() {
    constexpr int steps = 100000;
    Real sum = 0;
    for (int i = 0; i <= steps; ++i) {
        const Real cosine = Real(i) / steps;
        sum += (i == 0 || i == steps ? 1 : i % 2 ? 4 : 2) * (i == 0 ? 0 : transmittance(cosine)) * 2 * cosine;
    }
    return sum / (3 * steps);
}

/// A square at this height, so wide that nothing gets round it; `turn`: 1 facing up, -1 down.
std::string wide(const char *material, float y, int turn) {
    return fmt::format(
        R"({{"type": "polygon", "material": "{0}", "vertices": [[-5000, {1}, {2}], [5000, {1}, {2}], [5000, {1}, {3}], [-5000, {1}, {3}]]}})",
        material, y, 5000 * turn, -5000 * turn);
}

std::string plate(float low, float high) { return wide("glass", high, 1) + ", " + wide("glass", low, -1); }

Scene scene_of(const std::string &objects, const std::string &camera) {
    Scene scene = read_text(fmt::format(R"({{
        "integrator": {{"type": "path", "max_depth": 100}}, "camera": {{{}, "fov": 1e-4, "up": [0.3, 0.2, 1]}},
        "materials": [{{"name": "glass", "type": "dielectric", "eta": 1.5}}, {{"name": "white", "type": "diffuse", "reflectance": 0.5}},
                      {{"name": "lamp", "type": "diffuse", "reflectance": 0, "emission": 1}}],
        "objects": [{}]}})",
                                        camera, objects));
    scene.film.sampler = kind_number(sampler_kinds(), "independent");
    scene.film.width = 64, scene.film.height = 64, scene.film.spp = 1024;
    return scene;
}

}  // namespace

/// An even lamp behind the plate, by the angle at which one looks through it.
TEST(GlassSlab, ALampIsAsBrightAsFresnelSays) {
    for (const Real angle : {0.0L, 0.7L, 1.2L}) {
        const std::string camera = fmt::format(R"("from": [{}, {}, 0], "at": [0, 0, 0])", double(5 * std::sin(angle)), double(5 * std::cos(angle)));
        SCOPED_TRACE(camera);
        expect_right_to_a_thousandth(estimate(scene_of(plate(-0.2f, 0) + ", " + wide("lamp", -3, 1), camera)), transmittance(std::cos(angle)),
                                     intervals);
    }
}

/// A floor under the plate, under a ceiling of light: what the floor reflects comes back from the plate in part, again and again.
TEST(GlassSlab, AFloorIsLitFromAllSides) {
    const Real passed = diffuse_transmittance();
    const Scene scene =
        scene_of(wide("white", 0, 1) + ", " + plate(1, 1.2f) + ", " + wide("lamp", 3, -1), R"("from": [0.3, 0.8, 0.2], "at": [0, 0, 0])");
    expect_right_to_a_thousandth(estimate(scene), 0.5L * passed / (1 - 0.5L * (1 - passed)), intervals);
}
