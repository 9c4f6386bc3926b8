#include "tools/bench/volumes_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>

#include "kernels/accelerators/bounding_volumes.h"
#include "kernels/core/items.h"
#include "runtime/opencl/kernel.h"
#include "runtime/selftest/oracle.h"
#include "runtime/wavefront/device_scene.h"
#include "scene/accelerators/accelerator.h"
#include "scene/accelerators/volume_fit.h"
#include "tools/median.h"
#include "tools/scene_options.h"
#include "tools/standard_output.h"

namespace brandung {
namespace {

using nlohmann::json;

constexpr const char *file = "kernels/bench/volumes.cl";
constexpr uint ray_count = 16384, volume_count = 1024, tests_of_ray = 256;
constexpr const char *kinds[VOLUME_KINDS] = {"box", "sphere", "ellipsoid", "oriented_box", "diagonals"};  // by VOLUME_...

struct Options : SceneOptions {
    bool as_json = false;
};

/// Uniform numbers from 0 to 1.
class Source {
public:
    float number() { return static_cast<float>(random_() >> 8) * 0x1p-24f; }
    vec3 point() {
        const float x = number(), y = number();
        return {x, y, number()};
    }

private:
    std::mt19937 random_{1};
};

std::vector<Ray> some_rays(Source &source) {
    std::vector<Ray> rays(ray_count);
    for (Ray &ray : rays) {
        const vec3 from = source.point();
        ray = {from, INFINITY, source.point() - from, RAY_TAG(RAY_CAMERA, NO_HIT)};
    }
    return rays;
}

class Tests {
public:
    explicit Tests(Device &device) : device_(device), rays_(device, some_rays(source_)), results_(device, ray_count) {}

    /// Of one test of each kind of volume [ns of one core]: the box's own, and of others what comes on top.
    std::array<double, VOLUME_KINDS> of_volumes() {
        std::vector<VolumeNode> nodes;
        std::array<std::vector<Volume>, VOLUME_KINDS> volumes;
        for (uint i = 0; i < volume_count; ++i) {
            std::vector<HullPart> parts;
            Bounds bounds;
            const vec3 middle = source_.point();
            for (uint k = 0; k < 4; ++k) bounds.add(parts.emplace_back(HullPart{.center = middle + 0.2f * source_.point()}).center);
            nodes.push_back({bounds.low, bounds.high, 0, 0});
            const FittedVolumes fitted = fit_volumes(parts);
            for (uint kind = 0; kind < VOLUME_KINDS; ++kind) volumes[kind].push_back(fitted[kind]);
        }
        Scene scene = scene_of(*primitive_oracles().front());
        const DeviceScene on_device(device_, compile(scene));
        Kernel kernel(device_, file, "test_volumes", on_device.lists());
        const Buffer<VolumeNode> node_buffer(device_, nodes);
        std::array<double, VOLUME_KINDS> costs;
        for (uint kind = 0; kind < VOLUME_KINDS; ++kind) {
            const Buffer<Volume> volume_buffer(device_, volumes[kind]);
            costs[kind] =
                nanoseconds([&] { kernel(ray_count, rays_, ray_count, 1.0f, node_buffer, volume_buffer, volume_count - 1, kind, results_); });
            if (kind != VOLUME_NONE) costs[kind] -= costs[VOLUME_NONE];
        }
        return costs;
    }

    /// Of one block of eight.
    double of_blocks(const PrimitiveOracle &oracle) {
        Scene scene = scene_of(oracle);
        const CompiledScene compiled = compile(scene, {.accelerator = &find_accelerator("none")});
        const DeviceScene on_device(device_, compiled);
        Kernel kernel(device_, file, "test_blocks", on_device.lists());
        return nanoseconds([&] { kernel(ray_count, on_device, rays_, ray_count, compiled.header.world.blocks[0].count - 1, results_); });
    }

private:
    /// Primitives of one kind, a tenth as large as the unit cube that all are in.
    Scene scene_of(const PrimitiveOracle &oracle) {
        Scene scene;
        scene.materials.push_back({"", {}});
        InputSource input(1);
        while (scene.shapes.size() < volume_count)
            if (auto shape = oracle.make(input, source_.point(), 0.1f)) scene.shapes.push_back(std::move(shape));
        return scene;
    }

    template <class Launch> double nanoseconds(Launch launch) {
        std::vector<double> milliseconds;
        for (int run = 0; run < 10; ++run) {
            const double before = total();
            launch();
            device_.finish();
            if (run > 0) milliseconds.push_back(total() - before);
        }
        return 1e6 * median(milliseconds) * device_.info().compute_units / (double(ray_count) * tests_of_ray);
    }
    double total() const {
        double sum = 0;
        for (const auto &[name, kernel] : device_.profile()) sum += kernel.milliseconds;
        return sum;
    }

    Device &device_;
    Source source_;
    Buffer<Ray> rays_;
    Buffer<uint> results_;
};

int run(const Options &options) {
    Device device = Device::select(options.device, options.threads);
    Tests tests(device);
    json all = {{"device", device.info().name}, {"nanoseconds", json::object()}};
    const auto costs = tests.of_volumes();
    for (uint kind = 0; kind < VOLUME_KINDS; ++kind) all["nanoseconds"][kinds[kind]] = costs[kind];
    for (const PrimitiveOracle *oracle : primitive_oracles())
        all["nanoseconds"][std::string("block: ") + oracle->kind().name] = tests.of_blocks(*oracle);
    if (options.as_json) {
        print_result(all.dump(2) + "\n");
        return 0;
    }
    std::string text = "test                 ns of one core\n";
    for (const auto &[name, cost] : all["nanoseconds"].items()) text += fmt::format("{:<20} {:14.1f}\n", name, cost.get<double>());
    print_result(text);
    return 0;
}

}  // namespace

void add_bench_volumes(CLI::App &bench, int &status) {
    CLI::App *command = bench.add_subcommand("volumes", "measure what a ray's test of each bounding volume costs, and of a block of primitives");
    auto options = std::make_shared<Options>();
    add_device_options(*command, *options);
    command->footer(
        "One ray against a thousand volumes or blocks, one after another; medians of nine runs. Volumes other than the box are tested after\n"
        "it: what that adds. These are B and J of the cost model by which bounding_volumes chooses its volumes.");
    command->option_defaults()->group("Bench");
    command->add_flag("--json", options->as_json, "print JSON");
    command->callback([options, &status] { status = run(*options); });
}

}  // namespace brandung
