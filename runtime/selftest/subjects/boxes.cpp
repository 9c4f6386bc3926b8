/// Boxes: none that a ray enters, exactly, is ever missed, and none is met that is further away than some of what boxes are grown by.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "kernels/core/items.h"
#include "runtime/opencl/kernel.h"
#include "runtime/selftest/describe.h"
#include "runtime/selftest/examine.h"
#include "runtime/selftest/extended.h"
#include "runtime/selftest/input_source.h"
#include "runtime/selftest/subjects/list.h"

namespace brandung {
namespace {

constexpr std::size_t inputs_per_round = 1 << 20;
constexpr float infinity = std::numeric_limits<float>::infinity();

struct Box {
    vec3 low, high;
};
struct Case {
    Box box;
    float extent;
    Ray ray;
};

/// Whether the ray enters the box, grown by `pad`, at some t in [0, t_max].
bool enters(const Box &box, const Ray &ray, extended pad) {
    extended near = 0, far = ray.t_max;
    for (int axis = 0; axis < 3; ++axis) {
        const extended o = ray.origin[axis], d = ray.direction[axis], low = extended(box.low[axis]) - pad, high = extended(box.high[axis]) + pad;
        if (d == 0) {
            if (o < low || o > high) return false;
            continue;
        }
        const extended a = (low - o) / d, b = (high - o) / d;
        near = greater(near, lesser(a, b)), far = lesser(far, greater(a, b));
    }
    return near <= far;
}

/// Boxes of all sizes and places, flat ones too, and rays through their corners, edges, faces and past them; some lie in faces.
Case make_case(InputSource &source) {
    const float size = source.power_of_two(-20, 20);
    const vec3 center = source.direction() * (size * source.power_of_two(-2, 20));
    vec3 half = {size * source.uniform(0, 1), size * source.uniform(0, 1), size * source.uniform(0, 1)};
    if (source.one_in(4)) half[int(source.below(3))] = 0;
    const Box box{center - half, center + half};
    vec3 target;
    for (int axis = 0; axis < 3; ++axis) {
        const float ends[] = {box.low[axis], box.high[axis], center[axis] + source.uniform(-1.2, 1.2) * half[axis]};
        target[axis] = ends[source.below(3)];
    }
    vec3 direction = source.direction();
    if (source.one_in(3)) direction[int(source.below(3))] = source.one_in(2) ? 0.0f : source.subnormal();
    if (source.one_in(6)) direction = vec3(0), direction[int(source.below(3))] = source.sign();
    direction *= source.one_in(4) ? source.power_of_two(-8, 8) : 1.0f;
    const vec3 origin = source.one_in(5) ? target : target - direction * (size * source.power_of_two(-4, 16));
    const float extent =
        std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.low.z), std::abs(box.high.x), std::abs(box.high.y), std::abs(box.high.z)});
    const float end = source.one_in(4) ? glm::length(target - origin) / glm::length(direction) : infinity;
    return {box, extent, {.origin = origin, .t_max = end, .direction = direction, .tag = RAY_TAG(RAY_CAMERA, NO_HIT)}};
}

class Boxes final : public Subject {
public:
    explicit Boxes(Device &device)
        : device_(device),
          kernel_(device, "kernels/selftest/boxes.cl", "test_boxes",
                  {{"generated/time.cl", "#include \"kernels/core/no_time.cl\"\n"},
                   {"generated/work.cl", "#include \"kernels/accelerators/no_work.cl\"\n"}}) {}

    Findings examine(uint round) override {
        std::vector<Box> boxes(inputs_per_round);
        std::vector<float> extents(inputs_per_round);
        std::vector<Ray> rays(inputs_per_round);
        for_parts(inputs_per_round, [&](std::size_t first, std::size_t last) {
            InputSource source(seed_of(6, round, first));
            for (std::size_t i = first; i < last; ++i) {
                const Case one = make_case(source);
                boxes[i] = one.box, extents[i] = one.extent, rays[i] = one.ray;
            }
        });
        Buffer<std::uint8_t> results(device_, inputs_per_round);
        kernel_(inputs_per_round, Buffer<Box>(device_, boxes), Buffer<float>(device_, extents), Buffer<Ray>(device_, rays),
                static_cast<uint>(inputs_per_round), results);
        const std::vector<std::uint8_t> hits = results.read();
        device_.finish();
        return examine_each(inputs_per_round,
                            [&](std::size_t i, Findings &findings) { look_at(boxes[i], extents[i], rays[i], hits[i] != 0, findings); });
    }

private:
    /// Boxes are grown by 2^-20 of the largest coordinates; twice that leaves room for the products' rounding.
    static void look_at(const Box &box, float extent, const Ray &ray, bool hit, Findings &findings) {
        const bool must = enters(box, ray, 0), may = must || enters(box, ray, 0x1p-19 * (largest(Vector(ray.origin)) + extent));
        findings.hits += hit;
        findings.ambiguous += may != must;
        if (hit == must || hit == may) return;
        findings.blame([&] {
            return fmt::format("{}: box from {} to {}, ray from {} in direction {} to t {:a}", hit ? "made up" : "overlooked", text_of(box.low),
                               text_of(box.high), text_of(ray.origin), text_of(ray.direction), ray.t_max);
        });
    }

    Device &device_;
    Kernel kernel_;
};

}  // namespace

void add_boxes(std::vector<SubjectEntry> &list) {
    list.push_back({"boxes", "core/lane_ray.cl", "never overlooked; made up within twice the pad", 1,
                    [](Device &device) { return std::make_unique<Boxes>(device); }});
}

}  // namespace brandung
