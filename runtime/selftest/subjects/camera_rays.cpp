/// Rays of the pinhole camera.
#include <fmt/format.h>

#include <algorithm>

#include "kernels/cameras/perspective.h"
#include "kernels/core/params.h"
#include "runtime/selftest/describe.h"
#include "runtime/selftest/examine.h"
#include "runtime/selftest/extended.h"
#include "runtime/selftest/precision.h"
#include "runtime/selftest/subjects/list.h"
#include "scene/kinds.h"

namespace brandung {
namespace {

constexpr std::size_t inputs_per_round = 1 << 18;

/// As kernels have it, in float or in double.
template <class Number> struct CameraOf {
    glm::vec<3, Number> position;
    uint width, height;
    Number words[CAMERA_WORDS];
    explicit CameraOf(const Camera &c) : position(c.position), width(c.width), height(c.height) { std::ranges::copy(c.words, words); }
};

/// Of all angles of view up to 179 degrees, wide and narrow pictures, anywhere.
Camera any_camera(InputSource &source) {
    const glm::dvec3 forward(source.direction()), other(source.direction());
    const glm::dvec3 right = glm::normalize(glm::cross(forward, other)), down = glm::cross(forward, right);
    const double height = std::exp2(source.uniform(-16, 8)), width = height * std::exp2(source.uniform(-4, 4));
    Camera camera{.position = source.direction() * source.power_of_two(-20, 20), .width = 1, .height = 1, .words = {}};
    const vec3 corner(forward - width / 2 * right - height / 2 * down);
    write_words(Perspective{.corner = corner, .right = vec3(width * right), .down = vec3(height * down)}, camera.words);
    return camera;
}

class CameraRays final : public Subject {
public:
    explicit CameraRays(Device &device) : device_(device), kernel_(device, "kernels/selftest/camera_rays.cl", "test_camera_rays") {}

    Findings examine(uint round) override {
        std::vector<Camera> cameras(inputs_per_round);
        std::vector<vec2> points(inputs_per_round);
        InputSource source(seed_of(8, round, 0));
        for (std::size_t i = 0; i < inputs_per_round; ++i) {
            cameras[i] = any_camera(source);
            points[i] = source.one_in(8) ? vec2(source.below(3) / 2.0f, source.below(3) / 2.0f) : vec2(source.uniform(0, 1), source.uniform(0, 1));
        }
        const std::vector<vec3> directions = run<float>(kernel_.in_float, cameras, points);
        const auto doubles = kernel_.in_double ? run<double>(*kernel_.in_double, cameras, points) : std::vector<glm::dvec3>();
        device_.finish();
        return examine_each(inputs_per_round, [&](std::size_t i, Findings &findings) {
            look_at(cameras[i], points[i], directions[i], kernel_.in_double ? &doubles[i] : nullptr, findings);
        });
    }

private:
    template <class Number>
    std::vector<glm::vec<3, Number>> run(Kernel &kernel, const std::vector<Camera> &cameras, const std::vector<vec2> &points) {
        Buffer<glm::vec<3, Number>> results(device_, inputs_per_round);
        kernel(inputs_per_round, Buffer<CameraOf<Number>>(device_, std::vector<CameraOf<Number>>(cameras.begin(), cameras.end())),
               Buffer<glm::vec<2, Number>>(device_, std::vector<glm::vec<2, Number>>(points.begin(), points.end())),
               static_cast<uint>(inputs_per_round), results);
        return results.read();
    }

    /// The sum has 4 roundings, of magnitudes up to that of its terms; unit() adds 4 u.
    static void look_at(const Camera &camera, vec2 point, vec3 direction, const glm::dvec3 *in_double, Findings &findings) {
        const Perspective view = view_of<Perspective>(camera.words);
        const Vector corner = view.corner, right = Vector(view.right) * point.x, down = Vector(view.down) * point.y, sum = corner + right + down;
        const extended allowed = 4 * unit_roundoff * ((length(corner) + length(right) + length(down)) / length(sum) + 1);
        ++findings.hits;
        if (in_double)
            findings.rounding_of(Quantity::normal).add(glm::distance(glm::dvec3(direction), *in_double), double(allowed), 2 * unit_roundoff, 1);
        findings.measure(Quantity::normal, double(length(Vector(direction) - unit(sum))), double(allowed), 2 * unit_roundoff, 1, [&] {
            return fmt::format("direction {} of corner {} + {:a} {} + {:a} {}", text_of(direction), text_of(view.corner), point.x,
                               text_of(view.right), point.y, text_of(view.down));
        });
    }

    Device &device_;
    KernelInBoth kernel_;
};

}  // namespace

void add_camera_rays(std::vector<SubjectEntry> &list) {
    list.push_back({"camera_rays", "cameras/perspective.cl", "4 roundings of the sum's terms, and of unit length", 1,
                    [](Device &device) { return std::make_unique<CameraRays>(device); }});
}

}  // namespace brandung
