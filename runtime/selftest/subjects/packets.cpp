/// Packets of rays: the same bits as rays one after another, and both say of the same rays that they are occluded.
#include <fmt/format.h>

#include <numeric>

#include "runtime/opencl/kernel.h"
#include "runtime/selftest/crossing_cases.h"
#include "runtime/selftest/describe.h"
#include "runtime/selftest/examine.h"
#include "runtime/selftest/subjects/list.h"
#include "runtime/wavefront/device_scene.h"

namespace brandung {
namespace {

constexpr std::size_t inputs_per_round = 1 << 17;
constexpr uint shapes_per_kind = 512;

/// Things of every kind, small and large, in a ball of radius 1 about a place.
CompiledScene compiled_crowd(vec3 place) {
    Scene scene;
    scene.materials.emplace_back();
    InputSource source(seed_of(13, 0, 0));
    for (const PrimitiveOracle *oracle : primitive_oracles())
        for (uint i = 0; i < shapes_per_kind; ++i)
            if (auto shape = oracle->make(source, place + source.in_cube(0.57f), source.power_of_two(-8, -2)))
                scene.shapes.push_back(std::move(shape));
    return compile(scene);
}

/// From one place to places that are near each other, or far; some end on the way.
std::vector<Ray> make_rays(InputSource &source, vec3 place) {
    std::vector<Ray> rays(inputs_per_round);
    vec3 origin, target;
    float spread = 1;
    for (std::size_t i = 0; i < inputs_per_round; ++i) {
        if (i % 16 == 0) {
            origin = place + source.direction() * source.power_of_two(-4, 4), target = place + source.in_cube(0.57f);
            spread = source.power_of_two(-20, 0);
        }
        const vec3 from = origin + source.in_cube(spread), way = target + source.in_cube(spread) - from;
        rays[i] = {.origin = from,
                   .t_max = source.one_in(4) ? source.uniform(0, 1.5) : std::numeric_limits<float>::infinity(),
                   .direction = source.one_in(16) ? vec3(0, source.sign(), 0) : way,
                   .tag = RAY_TAG(RAY_CAMERA, NO_HIT)};
    }
    return rays;
}

class Packets final : public Subject {
public:
    explicit Packets(Device &device) : device_(device) {
        for (const vec3 place : places) scenes_.emplace_back(device, compiled_crowd(place));
        kernel_.emplace(device, "kernels/selftest/packets.cl", "test_packets", scenes_.front().lists());
    }

    Findings examine(uint round) override {
        const uint which = round % 2;
        InputSource source(seed_of(14, round, 0));
        const std::vector<Ray> rays = make_rays(source, places[which]);
        std::vector<uint> live(rays.size());
        std::iota(live.begin(), live.end(), 0u);
        Buffer<std::uint8_t> results(device_, rays.size());
        Buffer<Hit> hits(device_, rays.size());
        (*kernel_)(rays.size(), scenes_[which], Buffer<Ray>(device_, rays), Buffer<uint>(device_, live), static_cast<uint>(rays.size()), hits,
                   results);
        const std::vector<std::uint8_t> differences = results.read();
        const std::vector<Hit> met = hits.read();
        device_.finish();
        return examine_each(rays.size(), [&](std::size_t i, Findings &findings) {
            findings.hits += met[i].primitive != NO_HIT;
            if (differences[i] == 0) return;
            const char *what = (differences[i] & 1) != 0 ? "in a packet it meets something else" : "it is not said alike to be occluded";
            findings.blame([&] {
                return fmt::format("{}: ray from {} in direction {} to t {:a}; round {}, input {}", what, text_of(rays[i].origin),
                                   text_of(rays[i].direction), rays[i].t_max, round, i);
            });
        });
    }

private:
    static constexpr vec3 places[] = {{0, 0, 0}, {1000, -300, 200}};

    Device &device_;
    std::vector<DeviceScene> scenes_;
    std::optional<Kernel> kernel_;
};

}  // namespace

void add_packets(std::vector<SubjectEntry> &list) {
    list.push_back({"packets", "accelerators/packet.cl, wide_bvh.cl", "the bits of rays one after another", 4,
                    [](Device &device) { return std::make_unique<Packets>(device); }});
}

}  // namespace brandung
