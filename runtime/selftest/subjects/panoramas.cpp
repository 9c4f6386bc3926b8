/// Places in pictures that are all around.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "runtime/selftest/describe.h"
#include "runtime/selftest/examine.h"
#include "runtime/selftest/extended.h"
#include "runtime/selftest/input_source.h"
#include "runtime/selftest/precision.h"
#include "runtime/selftest/subjects/list.h"

namespace brandung {
namespace {

constexpr std::size_t inputs_per_round = 1 << 16;

/// Anywhere, along axes, in their planes, and next to them; of any length.
vec3 any_direction(InputSource &source) {
    vec3 d = source.direction();
    if (source.one_in(4)) d[int(source.below(3))] = source.one_in(2) ? 0.0f : source.sign() * source.power_of_two(-60, -10);
    if (source.one_in(8)) d = vec3(0), d[int(source.below(3))] = source.sign();
    return d * (source.one_in(4) ? source.power_of_two(-8, 8) : 1.0f);
}

class Panoramas final : public Subject {
public:
    explicit Panoramas(Device &device) : device_(device), kernel_(device, "kernels/selftest/panoramas.cl", "test_panoramas") {}

    Findings examine(uint round) override {
        std::vector<vec3> directions(inputs_per_round);
        std::vector<float> turns(inputs_per_round);
        InputSource source(seed_of(17, round, 0));
        for (std::size_t i = 0; i < inputs_per_round; ++i)
            directions[i] = any_direction(source), turns[i] = source.one_in(4) ? 0.0f : source.uniform(-1, 1);
        const std::vector<vec2> places = run<float>(kernel_.in_float, directions, turns);
        const auto doubles = kernel_.in_double ? run<double>(*kernel_.in_double, directions, turns) : std::vector<glm::dvec2>();
        device_.finish();
        return examine_each(inputs_per_round, [&](std::size_t i, Findings &findings) {
            look_at(directions[i], turns[i], places[i], kernel_.in_double ? &doubles[i] : nullptr, findings);
        });
    }

private:
    template <class Number>
    std::vector<glm::vec<2, Number>> run(Kernel &kernel, const std::vector<vec3> &directions, const std::vector<float> &turns) {
        Buffer<glm::vec<2, Number>> results(device_, inputs_per_round);
        kernel(inputs_per_round, Buffer<glm::vec<3, Number>>(device_, std::vector<glm::vec<3, Number>>(directions.begin(), directions.end())),
               Buffer<Number>(device_, std::vector<Number>(turns.begin(), turns.end())), static_cast<uint>(inputs_per_round), results);
        return results.read();
    }

    /// Arctangents are off by 9 u, as angles up to pi: as turns by 1.5 u, as half turns by 3 u; the rest is rounding of numbers up to 2. The picture
    /// goes around.
    static void look_at(vec3 d, float turn, vec2 place, const glm::dvec2 *in_double, Findings &findings) {
        constexpr long double pi = std::numbers::pi_v<long double>;
        const long double x = d.x, y = d.y, z = d.z;
        const double u = double(0.5L + std::atan2(x, -z) / (2 * pi) + turn), v = double(0.5L + std::atan2(y, std::sqrt(x * x + z * z)) / pi);
        const double off_u = std::abs(std::remainder(place.x - u, 1.0)), off_v = std::abs(place.y - v), allowed = 7 * unit_roundoff;
        const auto describe = [&] {
            return fmt::format("({:.9g}, {:.9g}), and not ({:.9g}, {:.9g}), of direction {}, turned by {:a}", place.x, place.y, u, v, text_of(d),
                               turn);
        };
        ++findings.hits;
        if (in_double) {
            findings.rounding_of(Quantity::uv).add(std::abs(std::remainder(place.x - in_double->x, 1.0)), allowed, 2 * unit_roundoff, 1);
            findings.rounding_of(Quantity::uv).add(std::abs(place.y - in_double->y), allowed, 2 * unit_roundoff, 1);
        }
        findings.measure(Quantity::uv, off_u, allowed, 2 * unit_roundoff, 1, describe);
        findings.measure(Quantity::uv, off_v, allowed, 2 * unit_roundoff, 1, describe);
    }

    Device &device_;
    KernelInBoth kernel_;
};

}  // namespace

void add_panoramas(std::vector<SubjectEntry> &list) {
    list.push_back({"panoramas", "textures/panorama.cl", "arctangents to 2.25 ulp, and 5 roundings of numbers up to 2", 2,
                    [](Device &device) { return std::make_unique<Panoramas>(device); }});
}

}  // namespace brandung
